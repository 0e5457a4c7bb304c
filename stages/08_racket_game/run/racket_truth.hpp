#pragma once
#include <utility>

#include "08_racket_game/exact/walk.hpp"
#include "08_racket_game/reference/racket_contacts.hpp"

namespace bounce {

/// What a ball beside a racket in uniform motion is compared with (Truth): the closed form as far
/// as it goes; from the moment on at which the ball meets the rim, the reference. It goes from the
/// start again: up to the rim the two agree.
class RacketTruth {
 public:
  using Ball = State<Eigen::Vector3d>;
  using AtRim = RacketReference;

  RacketTruth(RacketWalk walk, AtRim at_rim) : walk_(std::move(walk)), at_rim_(std::move(at_rim)) {}

  bool reach(double t, long long most_events) {
    if (!is_at_rim_) {
      if (!walk_.reach(t, most_events)) return false;
      is_at_rim_ = walk_.meets_rim_before(t);
    }
    return !is_at_rim_ || at_rim_.reach(t, most_events);
  }
  double last_event() const { return is_at_rim_ ? at_rim_.last_event() : walk_.last_event(); }
  Ball at(double t) { return is_at_rim_ ? walk_.to_ground(at_rim_.at(t), t) : walk_.at(t); }

 private:
  RacketWalk walk_;
  AtRim at_rim_;
  bool is_at_rim_ = false;
};

}  // namespace bounce
