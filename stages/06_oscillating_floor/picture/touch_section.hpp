#pragma once
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/playback.hpp"
#include "run/rows.hpp"

namespace bounce {

/// The Poincare section of the run that is seen: for each touch, where in its swing the floor was,
/// and how fast ball and floor came together. Bounces that are all alike are one point, bounces
/// that take turns are two; chaos is a cloud with a shape. Pale, below: where the exact ball comes
/// by, after it has had time to settle from where the run was when the floor changed.
class TouchSection {
 public:
  void draw(Canvas& canvas, Rect area, const Playback& playback) {
    follow(playback);
    double fastest = 1;
    for (const Bounce& bounce : exact_) fastest = std::max(fastest, bounce.speed);
    for (const Touch<double>& touch : touches_) fastest = std::max(fastest, -touch.velocity);
    const Diagram diagram{plot_box(area, 24), {0, 2 * std::numbers::pi}, {0, std::ceil(fastest)}};
    diagram.draw(canvas, "speed of each touch, m/s, by the floor's angle", 5, 4, " rad");
    for (const Bounce& bounce : exact_) {
      const Point at = diagram.at(bounce.phase, bounce.speed);
      draw_rect(canvas, {at.x - 1, at.y - 1, 2, 2}, palette::exact.faded(0.4));
    }
    for (const Touch<double>& touch : touches_) {
      const Point at = diagram.at(touch.angle, -touch.velocity);
      draw_rect(canvas, {at.x - 1.5f, at.y - 1.5f, 3, 3}, palette::motion.faded(0.75));
    }
    if (!touches_.empty()) {
      const Touch<double>& last = touches_.back();
      canvas.disc(diagram.at(last.angle, -last.velocity), 5, palette::motion);
    }
  }

 private:
  /// The trace has the ball every few milliseconds. From a moment in the air the exact solution
  /// tells whether, and when, it touches before the next.
  void follow(const Playback& playback) {
    const OscillatingFloor scene = run_as<OscillatingFloorRun>(playback.simulation()).scene();
    const std::deque<TracePoint>& trace = playback.trace();
    const bool is_other = scene.amplitude != amplitude_ || scene.angular_frequency != w_;
    if (is_other || trace.back().t < until_) {
      touches_.clear();
      try {
        exact_ = settled_bounces(from_now(scene, trace.back()), 300, 1000);
      } catch (const TimeStandsStill&) {
        exact_.clear();  // a contact that cannot be followed
      }
      until_ = is_other ? trace.back().t : trace.front().t;
      amplitude_ = scene.amplitude;
      w_ = scene.angular_frequency;
    }
    std::size_t next = trace.size() - 1;
    while (next > 0 && trace[next - 1].t >= until_) --next;
    OscillatingFloorExact phases(scene);
    for (; next + 1 < trace.size(); ++next) {
      const double t = trace[next].t, length = trace[next + 1].t - t;
      const State<double> ball = state_in<double>(trace[next].values);
      phases.begin(t);
      if (phases.phase_at(ball) != Phase::flight) continue;
      const PhaseEnd end = phases.end_of(Phase::flight, ball);
      if (!(end.after <= length) || end.next == Phase::flight) continue;
      touches_.push_back(touch_at(scene, t + end.after, fly(ball, scene.gravity, end.after)));
      if (touches_.size() > most) touches_.pop_front();
    }
    until_ = trace.back().t;
  }
  /// The scene that begins where the run is.
  static OscillatingFloor from_now(OscillatingFloor scene, const TracePoint& now) {
    scene.start = state_in<double>(now.values);
    scene.start.position -= scene.floor_velocity * now.t;
    scene.phase = within_one_turn(scene.angular_frequency * now.t + scene.phase);
    return scene;
  }

  static constexpr std::size_t most = 2000;
  std::vector<Bounce> exact_;
  std::deque<Touch<double>> touches_;
  double until_ = 0;  // s: touches before that are known
  double amplitude_ = 0, w_ = 0;
};

}  // namespace bounce
