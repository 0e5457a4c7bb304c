#pragma once
#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/sweep/lanes.hpp"
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

/// The touch of a ball that comes down at `t` [s].
inline Touch<double> touch_at(const OscillatingFloor& scene, double t, const State<double>& ball) {
  return {within_one_turn(scene.angular_frequency * t + scene.phase),
          ball.velocity - scene.floor_speed(t)};
}

/// The bounces of a ball, by the exact solution.
class ExactBounces {
 public:
  explicit ExactBounces(const OscillatingFloor& scene)
      : scene_(scene), walker_(OscillatingFloorExact(scene), 0, scene.start) {}

  /// From the end of a touch of a floor that swings and does no more; where the end is not sure,
  /// from the touch itself.
  ExactBounces(const OscillatingFloor& scene, const Touch<double>& touch,
               const LiftOff<double>& end)
      : scene_(scene),
        walker_(OscillatingFloorExact(scene), time_of(touch) + end.t, state_at(touch, end)),
        impact_(touch),
        is_flying_(end.is_sure && walker_.phase() == Phase::flight) {}

  /// The next one; nothing when the ball comes to stay on the floor, or flies away. (It may stay
  /// and be let go and touched again in every swing: so many such events without a lift-off are
  /// enough.)
  std::optional<Bounce> next() {
    for (int event = 0; event < 300 && walker_.next_event() != never; ++event) {
      if (!is_flying_) {
        const Phase before = walker_.phase();
        walker_.pass_event();
        const Phase now = walker_.phase();
        if (before == Phase::flight && now != Phase::flight) {
          impact_ = touch_at(scene_, walker_.last_event(), walker_.state_at_last_event());
        }
        if (before == Phase::flight || now != Phase::flight || !impact_) continue;
        if (walker_.next_event() == never) break;
      }
      is_flying_ = false;
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
    return touch_at(scene_, t, ball);
  }

 private:
  double time_of(const Touch<double>& touch) const {
    return (touch.angle - scene_.phase) / scene_.angular_frequency;
  }
  State<double> state_at(const Touch<double>& touch, const LiftOff<double>& end) const {
    const double t = time_of(touch) + end.t;
    return {scene_.radius + scene_.floor_height(t) + end.x, scene_.floor_speed(t) + end.velocity};
  }

  OscillatingFloor scene_;
  EventDriven<OscillatingFloorExact> walker_;
  std::optional<Touch<double>> impact_;  // the last one
  bool is_flying_ = false;               // after that, from the beginning on
};

/// One ball of a sweep, on its way to where it settles.
struct SettlingBall {
  /// The next bounce by the exact solution. Returns the touch after it.
  Touch<double> bounce_exactly() {
    const std::optional<Bounce> bounce = exact.next();
    has_stopped = !bounce;
    if (!bounce) return {0, -1};  // of no use any more
    bounces.push_back(*bounce);
    return exact.touch_after();
  }

  OscillatingFloor scene;
  ExactBounces exact{scene};
  bool has_stopped = false;
  std::vector<Bounce> bounces = {};
};

/// As many balls as V has numbers take so many bounces: quick ones where they are sure, and exact
/// ones where they are not.
template <class V>
void settle_quickly(std::span<SettlingBall> balls, int bounces) {
  const QuickContact<V> contact = quick_contact<V>(balls[0].scene.contact, [&](auto member) {
    V numbers{};
    for (std::size_t i = 0; i < balls.size(); ++i) set_lane(numbers, i, balls[i].scene.*member);
    return numbers;
  });
  Touch<V> touch;
  const auto go_exactly = [&](std::size_t i) {
    const Touch<double> next = balls[i].bounce_exactly();
    set_lane(touch.angle, i, next.angle);
    set_lane(touch.velocity, i, next.velocity);
  };
  for (std::size_t i = 0; i < balls.size(); ++i) go_exactly(i);
  const auto has_stopped = [](const SettlingBall& ball) { return ball.has_stopped; };
  for (int n = 1; n < bounces && !std::all_of(balls.begin(), balls.end(), has_stopped); ++n) {
    const NextTouch<V> next = next_touch(contact, touch);
    const Touch<V> before = touch;
    touch = next.touch;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      SettlingBall& ball = balls[i];
      const Touch<double> from{lane(before.angle, i), lane(before.velocity, i)};
      if (ball.has_stopped) {  // it goes along, where it is
        set_lane(touch.angle, i, from.angle);
        set_lane(touch.velocity, i, from.velocity);
      } else if (lane(next.is_sure, i)) {
        const double height = lane(next.highest, i);
        ball.bounces.push_back({within_one_turn(from.angle), -from.velocity, height});
      } else {
        LiftOff<double> end{0, 0, from.velocity, {}, false};
        if (lane(next.from.is_sure, i)) {
          end = {lane(next.from.t, i), lane(next.from.x, i), lane(next.from.velocity, i), {}, true};
        }
        ball.exact = ExactBounces(ball.scene, from, end);
        go_exactly(i);
      }
    }
  }
}

/// The bounces of balls after they have had time to settle: `discarded` go unseen, then `kept` are
/// written down. Fewer when a ball comes to stay on the floor, or flies away without gravity.
inline std::vector<std::vector<Bounce>> settled_bounces(std::span<const OscillatingFloor> scenes,
                                                        int discarded, int kept) {
  std::vector<std::vector<Bounce>> all;
  while (all.size() < scenes.size()) {
    const auto left = scenes.subspan(all.size());
    std::size_t quick = 0;  // that may go side by side
    while (quick < std::min(lanes, left.size()) && has_quick_contact(left[quick]) &&
           left[quick].contact == left[0].contact) {
      ++quick;
    }
    std::vector<SettlingBall> balls;
    for (const OscillatingFloor& scene : left.first(quick == lanes ? lanes : 1)) {
      balls.push_back({scene});
    }
    if (quick == lanes) {
      settle_quickly<Lanes>(balls, discarded + kept);
    } else if (quick > 0) {
      settle_quickly<double>(balls, discarded + kept);
    } else {
      for (int n = 0; n < discarded + kept && !balls[0].has_stopped; ++n) balls[0].bounce_exactly();
    }
    for (const SettlingBall& ball : balls) {
      const auto unseen = std::min(std::ssize(ball.bounces), std::ptrdiff_t{discarded});
      all.emplace_back(ball.bounces.begin() + unseen, ball.bounces.end());
    }
  }
  return all;
}

inline std::vector<Bounce> settled_bounces(const OscillatingFloor& scene, int discarded, int kept) {
  return settled_bounces({&scene, 1}, discarded, kept).front();
}

}  // namespace bounce
