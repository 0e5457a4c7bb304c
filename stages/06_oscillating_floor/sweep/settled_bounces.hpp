#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/quick_bounce.hpp"
#include "physics/events/event_driven.hpp"

namespace bounce {

/// One bounce: where in its swing the floor was hit, how fast the two came together, and how high
/// the ball rose after it.
struct Bounce {
  double phase;   // rad, 0 to 2 pi
  double speed;   // m/s
  double height;  // m
};

/// The bounces of a ball, by the exact solution.
class ExactBounces {
 public:
  explicit ExactBounces(const OscillatingFloor& scene)
      : scene_(scene), walker_(OscillatingFloorExact(scene), 0, scene.start) {}

  /// From a touch of a floor that swings and does no more.
  ExactBounces(const OscillatingFloor& scene, const Touch<double>& touch)
      : scene_(scene), walker_(OscillatingFloorExact(scene), time_of(touch), state_at(touch)) {
    impact_ = touch;
  }

  /// The next one; nothing when the ball comes to stay on the floor, or flies away.
  std::optional<Bounce> next() {
    while (walker_.next_event() != never) {
      const Phase before = walker_.phase();
      walker_.pass_event();
      const Phase now = walker_.phase();
      if (before == Phase::flight && now != Phase::flight) {
        impact_ = touch_of(walker_.last_event(), walker_.state_at_last_event());
      }
      if (before == Phase::flight || now != Phase::flight || !impact_) continue;
      if (walker_.next_event() == never) return std::nullopt;
      // The flight's highest point: its top, unless the floor comes before it.
      const State<double>& start = walker_.state_at_last_event();
      const double length = walker_.next_event() - walker_.last_event();
      const double to_top = std::clamp(start.velocity / scene_.gravity, 0.0, length);
      return Bounce{impact_->angle, -impact_->velocity,
                    fly(start, scene_.gravity, to_top).position};
    }
    return std::nullopt;
  }

  /// The touch that ends the flight after that bounce.
  Touch<double> touch_after() const {
    const double t = walker_.next_event();
    const State<double> ball =
        fly(walker_.state_at_last_event(), scene_.gravity, t - walker_.last_event());
    return touch_of(t, ball);
  }

 private:
  Touch<double> touch_of(double t, const State<double>& ball) const {
    return {within_one_turn(scene_.angular_frequency * t + scene_.phase),
            ball.velocity - scene_.floor_speed(t)};
  }
  double time_of(const Touch<double>& touch) const {
    return (touch.angle - scene_.phase) / scene_.angular_frequency;
  }
  State<double> state_at(const Touch<double>& touch) const {
    const double t = time_of(touch);
    return {scene_.radius + scene_.floor_height(t), touch.velocity + scene_.floor_speed(t)};
  }

  OscillatingFloor scene_;
  EventDriven<OscillatingFloorExact> walker_;
  std::optional<Touch<double>> impact_;  // the last one
};

/// The bounces of a ball after it has had time to settle: `discarded` go unseen, then `kept` are
/// written down. Fewer when the ball comes to stay on the floor, or flies away without gravity.
/// Quick bounces where they are sure, and exact ones where they are not.
inline std::vector<Bounce> settled_bounces(const OscillatingFloor& scene, int discarded, int kept) {
  std::vector<Bounce> bounces;
  const auto note = [&](int n, const Bounce& bounce) {
    if (n >= discarded) bounces.push_back(bounce);
  };
  ExactBounces exact(scene);
  const bool is_quick = has_quick_contact(scene);
  QuickContact<double> quick;
  if (is_quick) quick = quick_contact<double>(scene.contact, [&](auto m) { return scene.*m; });
  std::optional<Touch<double>> touch;
  for (int n = 0; n < discarded + kept; ++n) {
    if (touch) {
      const NextTouch<double> next = next_touch(quick, *touch);
      if (next.is_sure) {
        note(n, {within_one_turn(touch->angle), -touch->velocity, next.highest});
        touch = next.touch;
        continue;
      }
      exact = ExactBounces(scene, *touch);
    }
    const std::optional<Bounce> bounce = exact.next();
    if (!bounce) break;
    note(n, *bounce);
    if (is_quick) touch = exact.touch_after();
  }
  return bounces;
}

}  // namespace bounce
