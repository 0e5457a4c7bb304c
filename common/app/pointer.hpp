#pragma once
#include <deque>

#include "app/demo.hpp"
#include "app/error_chart_view.hpp"

namespace bounce {

/// A ball that is held with the pointer follows it, and leaves with the pointer's mean velocity
/// over the last 80 ms (a single movement of a mouse is too jumpy).
class HeldBall {
 public:
  bool is_held() const { return is_held_; }
  /// The pointer went down: on the ball, or elsewhere.
  void take(const Demo& demo, const Playback& playback, const View& view, Point at);
  void let_go() { is_held_ = false; }
  /// Once a frame; `clock` in real seconds.
  void follow(const Demo& demo, Playback& playback, const View& view, double clock, Point at);

 private:
  struct Sample {
    double t;
    Point at;
  };
  bool is_held_ = false;
  std::deque<Sample> way_;
};

/// A click on a dot of the chart of errors takes its method and its time step. Returns whether the
/// click was the chart's.
bool choose_from_chart(const Demo& demo, const View& view, const ErrorChart& chart,
                       Playback& playback, Point at);

}  // namespace bounce
