#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven.hpp"

namespace bounce {

/// One ball of a parameter sweep: what it is like, and how it starts.
struct SweepBall {
  double mass, gravity, radius;  // kg, m/s^2, m
  SpringDamper contact;
  State<double> start;  // m, m/s
  BouncePhases phases() const { return {mass, gravity, radius, contact}; }
};

// Many balls at once, each with parameters of its own, in closed form as in EventDriven. Eight of
// them go side by side, each in a lane of the processor's vector units: one instruction serves
// several balls, and none waits for another's result. A lane whose ball is done takes the next one.
namespace lanes {

constexpr int count = 8;
using Lanes = Eigen::Array<double, count, 1>;

/// Sine and cosine for angles from 0 to pi/2, by their Taylor series around pi/4 up to the power
/// 17: (pi/4)^18 / 18! = 2e-18 is below rounding.
inline void sine_cosine(const Lanes& angle, Lanes& sine, Lanes& cosine) {
  const Lanes x = angle - std::numbers::pi / 4, x2 = x * x;
  Lanes s = Lanes::Ones(), c = Lanes::Ones();  // sin x / x and cos x, from the last term back
  for (int n = 16; n >= 2; n -= 2) {
    s = 1 - s * x2 * (1.0 / (n * (n + 1)));
    c = 1 - c * x2 * (1.0 / (n * (n - 1)));
  }
  s *= x;
  sine = (c + s) * std::numbers::sqrt2 / 2;
  cosine = (c - s) * std::numbers::sqrt2 / 2;
}

/// The angle of the point (q, p) with p > 0, from 0 to pi: atan2(p, q).
inline Lanes angle_of(const Lanes& p, const Lanes& q) {
  // Folded into the eighth of the circle next to the axis, where tan = z <= 1.
  const Lanes width = q.abs();
  const Lanes z = p.min(width) / p.max(width);
  // z / (1 + 0.28 z^2) is within 0.005 of the angle. The rest is the angle seen after turning back
  // by the guess; its series z - z^3/3 + z^5/5 leaves out 0.005^7 / 7 = 1e-17.
  const Lanes guess = z / (1 + 0.28 * z * z);
  Lanes sine, cosine;
  sine_cosine(guess, sine, cosine);
  const Lanes rest = (z * cosine - sine) / (cosine + z * sine), rest2 = rest * rest;
  const Lanes folded = guess + rest * (1 - rest2 * (1.0 / 3 - rest2 / 5));
  // Unfolded.
  const Lanes steep = (p > width).select(std::numbers::pi / 2 - folded, folded);
  return (q < 0).select(std::numbers::pi - steep, steep);
}

/// Under-damped balls on a floor of the slides' law, one in each lane, from touch to touch.
class Bounces {
 public:
  /// Puts a ball into a lane; it touches the floor at `t` [s] with `speed` [m/s, downwards].
  void enter(int lane, const SweepBall& ball, double t, double speed) {
    gravity_[lane] = ball.gravity;
    omega0_squared_[lane] = ball.contact.stiffness / ball.mass;
    beta_[lane] = ball.contact.damping / (2 * ball.mass);
    w_[lane] = std::sqrt(omega0_squared_[lane] - beta_[lane] * beta_[lane]);
    sag_[lane] = ball.gravity / omega0_squared_[lane];
    touch[lane] = t;
    touch_speed[lane] = speed;
  }

  /// Follows the contact that begins at `touch` in every lane, and the flight after it.
  void follow();

  /// The ball's next touch is this one; before, `touch` and `touch_speed` were those of the last.
  void go_on(int lane) {
    touch[lane] = next_touch[lane];
    touch_speed[lane] = lift_off_speed[lane];
  }

  Lanes touch = Lanes::Zero(), touch_speed = Lanes::Ones();  // s, m/s downwards
  Lanes lift_off, lift_off_speed;  // s (`never` for a ball that stays), m/s upwards
  Lanes next_touch;                // s

 private:
  // Empty lanes go along with the numbers of some ball, so that nothing is divided by 0.
  Lanes gravity_ = Lanes::Ones(), omega0_squared_ = Lanes::Ones(), beta_ = Lanes::Zero(),
        w_ = Lanes::Ones(), sag_ = Lanes::Ones();
};

inline void Bounces::follow() {
  // The contact pushes the ball back through its rest position (DampedOscillator::upward_zero).
  const Lanes p = w_ * sag_, q = touch_speed - beta_ * sag_;
  const Lanes to_rest = (std::numbers::pi + angle_of(p, q)) / w_;
  const Lanes speed = (-beta_ * to_rest).exp() * (p * p + q * q).sqrt();

  // From there x = speed / w exp(-beta s) sin(w s), until x = sag: Halley's method (rise()).
  Lanes s = Lanes::Zero(), x = Lanes::Zero(), v = speed;
  Lanes rising = Lanes::Ones();  // 0 where the top was passed, and it was too low
  for (int i = 0; i < 40; ++i) {
    const Lanes a = -2 * beta_ * v - omega0_squared_ * x;
    const Lanes newton = (sag_ - x) / v, bend = newton * a / v;
    const Lanes step = rising * (bend.abs() < 0.2).select(newton / (1 + bend / 2), newton);
    s += step;
    if ((w_ * step.abs() < 1e-5 && rising * bend.abs() < 1e-5).all()) {
      // What the next step would add is the cube of this one: below rounding. The velocity by
      // Taylor's series, for the same reason.
      const Lanes jerk = -2 * beta_ * a - omega0_squared_ * v;
      v += (a + jerk * step / 2) * step;
      break;
    }
    rising = (w_ * s > std::numbers::pi / 2).select(0, rising);
    Lanes sine, cosine;
    sine_cosine((w_ * s).min(std::numbers::pi / 2), sine, cosine);
    const Lanes envelope = speed * (-beta_ * s).exp();
    x = envelope * sine / w_;
    v = envelope * (cosine - beta_ / w_ * sine);
    rising = (v > 0).select(rising, 0);
    v = (rising > 0).select(v, speed);  // of no use any more, but divided by
  }
  lift_off = (rising > 0).select(touch + to_rest + s, never);
  lift_off_speed = v;
  next_touch = lift_off + 2 * v / gravity_;
}

}  // namespace lanes

/// Without a damper every bounce is the same: the flights and touches before `t` [s] are counted,
/// not followed. For a ball that starts above the floor; `touch` is its first touch [s] and `speed`
/// how fast it comes down then [m/s].
inline State<double> undamped_state(const SweepBall& ball, double touch, double speed, double t) {
  const BouncePhases phases = ball.phases();
  const PhaseEnd lift_off = phases.end_of(Phase::touch, {ball.radius, -speed});
  const double bounce = lift_off.after + 2 * speed / ball.gravity;
  const double into_bounce = t - touch - std::floor((t - touch) / bounce) * bounce;
  if (into_bounce < lift_off.after) {
    return phases.move(Phase::touch, {ball.radius, -speed}, into_bounce);
  }
  return fly({ball.radius, speed}, ball.gravity, into_bounce - lift_off.after);
}

/// The state of each ball of a sweep at time `t` [s]. The lanes serve the usual ball: one that
/// starts above the floor, under gravity, with an under-damped contact of the slides' law. Others
/// are handed to EventDriven.
class BatchSweep {
 public:
  BatchSweep(const std::vector<SweepBall>& balls, double t)
      : balls_(balls), t_(t), states_(balls.size()) {
    in_lane_.fill(none);
  }

  std::vector<State<double>> run() {
    for (int lane = 0; lane < lanes::count; ++lane) refill(lane);
    while (full_ > 0) {
      bounces_.follow();
      for (int lane = 0; lane < lanes::count; ++lane) pass_bounce(lane);
    }
    return std::move(states_);
  }

 private:
  std::size_t& in_lane(int lane) { return in_lane_[static_cast<std::size_t>(lane)]; }

  /// Puts the next ball that needs one into the lane. Those on the way that do not are done.
  void refill(int lane) {
    while (next_ < balls_.size()) {
      const std::size_t i = next_++;
      const SweepBall& b = balls_[i];
      const double height = b.start.position - b.radius;
      const double zeta = damping_ratio(b.contact.stiffness, b.contact.damping, b.mass);
      const bool is_usual = height >= 0 && b.gravity > 0 && zeta < 0.99 &&
                            (b.contact.law == ContactLaw::may_pull || zeta == 0);
      if (!is_usual) {
        states_[i] = EventDriven<BouncePhases>(b.phases(), 0, b.start).at(t_);
        continue;
      }
      const double speed = impact_speed(height, b.start.velocity, b.gravity);
      const double touch = time_to_fall(height, b.start.velocity, b.gravity, speed);
      if (t_ < touch) {
        states_[i] = fly(b.start, b.gravity, t_);
      } else if (zeta == 0) {
        states_[i] = undamped_state(b, touch, speed, t_);
      } else {
        bounces_.enter(lane, b, touch, speed);
        in_lane(lane) = i;
        ++full_;
        return;
      }
    }
  }

  void pass_bounce(int lane) {
    const std::size_t i = in_lane(lane);
    if (i == none) return;
    if (t_ >= bounces_.next_touch[lane]) {
      bounces_.go_on(lane);
      return;
    }
    const SweepBall& b = balls_[i];
    if (t_ < bounces_.lift_off[lane]) {
      states_[i] = b.phases().move(Phase::touch, {b.radius, -bounces_.touch_speed[lane]},
                                   t_ - bounces_.touch[lane]);
    } else {
      states_[i] =
          fly({b.radius, bounces_.lift_off_speed[lane]}, b.gravity, t_ - bounces_.lift_off[lane]);
    }
    in_lane(lane) = none;
    --full_;
    refill(lane);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const std::vector<SweepBall>& balls_;
  double t_;
  std::vector<State<double>> states_;
  lanes::Bounces bounces_;
  std::array<std::size_t, lanes::count> in_lane_;
  std::size_t next_ = 0;  // the first ball that has not been looked at
  int full_ = 0;          // lanes with a ball in them
};

inline std::vector<State<double>> exact_states(const std::vector<SweepBall>& balls, double t) {
  return BatchSweep(balls, t).run();
}

}  // namespace bounce
