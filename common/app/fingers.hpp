#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/canvas.hpp"

namespace bounce {

/// Fingers on a screen: the first one moves, and a second one swings for as long as it is down; so
/// does a tap of the first one, for a moment. Times in seconds of any clock, places in pixels.
class Fingers {
 public:
  static constexpr double tap = 0.2, swing = 0.25;  // s: a tap is shorter; its swing lasts so long
  static constexpr float still = 20;                // px that a tap may slip

  void down(std::int64_t which, Point at, double t) { all_.push_back({which, at, at, t}); }
  void move(std::int64_t which, Point at) {
    for (Finger& finger : all_) {
      if (finger.which == which) finger.at = at;
    }
  }
  void up(std::int64_t which, double t) {
    if (!all_.empty() && all_.front().which == which) {
      const Finger& first = all_.front();
      const float slipped = std::hypot(first.at.x - first.from.x, first.at.y - first.from.y);
      if (t - first.since < tap && slipped < still) swings_until_ = t + swing;
    }
    std::erase_if(all_, [which](const Finger& finger) { return finger.which == which; });
  }

  /// Where the racket shall be; nothing while no finger is down.
  std::optional<Point> at() const {
    return all_.empty() ? std::nullopt : std::optional<Point>(all_.front().at);
  }
  bool is_swinging(double t) const { return all_.size() > 1 || t < swings_until_; }

 private:
  struct Finger {
    std::int64_t which;
    Point at, from;
    double since;
  };
  std::vector<Finger> all_;
  double swings_until_ = -1;
};

}  // namespace bounce
