#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/closed_form.hpp"
#include "physics/event_driven.hpp"

namespace bounce {

/// One ball of a parameter sweep: what it is like, and how it starts.
struct SweepBall {
  double mass, gravity, radius;  // kg, m/s^2, m
  SpringDamper contact;
  State<double> start;  // m, m/s
};

// Many balls at once, each with parameters of its own, in closed form as in EventDriven. Eight of
// them go side by side, each in a lane of the processor's vector units: one instruction serves
// several balls, and none waits for another's result. Only the usual case runs like that: a ball
// that starts above the floor, under gravity, with an under-damped contact of the slides' law. All
// others are handed to EventDriven; without a damper that is faster than lanes, because the contact
// is then one arc tangent.
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

/// Where the walk of each lane stopped: the phase that lasts at the time asked for.
struct Last {
  Lanes flight_start, flight_speed;  // s, m/s upwards, of the last flight from the floor
  Lanes touch_start, touch_speed;    // s, m/s downwards, of the last touch
  Lanes touches;                     // 1 where the last phase is a touch
};

inline Lanes column(const SweepBall* balls, double (*value)(const SweepBall&)) {
  Lanes all;
  for (int i = 0; i < count; ++i) all[i] = value(balls[i]);
  return all;
}

/// Flights and touches in turn until `t_end`, in all lanes. `first` has the first touch filled in.
inline Last walk(const SweepBall* balls, Last last, double t_end) {
  const Lanes g = column(balls, [](const SweepBall& b) { return b.gravity; });
  const Lanes m = column(balls, [](const SweepBall& b) { return b.mass; });
  const Lanes k = column(balls, [](const SweepBall& b) { return b.contact.stiffness; });
  const Lanes beta = column(balls, [](const SweepBall& b) { return b.contact.damping; }) / (2 * m);
  const Lanes omega0_squared = k / m, sag = m * g / k;
  const Lanes w = (omega0_squared - beta * beta).sqrt();

  Lanes open = (last.touch_start < t_end).cast<double>();  // 1 where the walk goes on
  last.touches = open;
  while ((open > 0).any()) {
    // The contact pushes the ball back through its rest position (DampedOscillator::upward_zero).
    const Lanes p = w * sag, q = last.touch_speed - beta * sag;
    Lanes angle;
    for (int i = 0; i < count; ++i) angle[i] = std::numbers::pi + std::atan2(p[i], q[i]);
    const Lanes to_rest = angle / w;
    const Lanes speed = (-beta * to_rest).exp() * (p * p + q * q).sqrt();

    // From there x = speed / w exp(-beta s) sin(w s), until x = sag: Halley's method (rise()).
    Lanes s = Lanes::Zero(), v = speed, x = Lanes::Zero(), step = Lanes::Ones();
    Lanes stays = Lanes::Zero();
    for (int i = 0; i < 40 && (w * step > 1e-5).any(); ++i) {
      const Lanes a = -2 * beta * v - omega0_squared * x;
      const Lanes newton = (sag - x) / v, bend = newton * a / v;
      step = (bend.abs() < 0.2).select(newton / (1 + bend / 2), newton);
      // Past the top: it was too low. Lanes that are closed have nothing to find.
      stays = (v <= 0 || w * (s + step) > std::numbers::pi / 2 || stays > 0).cast<double>();
      step = (stays > 0 || open == 0).select(0, step);
      s += step;
      Lanes sine, cosine;
      sine_cosine(w * s, sine, cosine);
      const Lanes envelope = speed * (-beta * s).exp();
      x = envelope * sine / w;
      v = envelope * (cosine - beta / w * sine);
    }
    const Lanes lift_off = last.touch_start + to_rest + s;
    const Lanes leaves = (open > 0 && stays == 0 && lift_off < t_end).cast<double>();
    last.flight_start = (leaves > 0).select(lift_off, last.flight_start);
    last.flight_speed = (leaves > 0).select(v, last.flight_speed);
    last.touches = (leaves > 0).select(0, last.touches);

    const Lanes touch = last.flight_start + 2 * last.flight_speed / g;
    open = (leaves > 0 && touch < t_end).cast<double>();
    last.touch_start = (open > 0).select(touch, last.touch_start);
    last.touch_speed = (open > 0).select(last.flight_speed, last.touch_speed);
    last.touches = (open > 0).select(1, last.touches);
  }
  return last;
}

}  // namespace lanes

/// The state of each ball at time `t` [s].
inline std::vector<State<double>> exact_states(const std::vector<SweepBall>& balls, double t) {
  const auto phases_of = [](const SweepBall& b) {
    return BouncePhases(b.mass, b.gravity, b.radius, b.contact);
  };
  const auto is_usual = [](const SweepBall& b) {
    return b.start.position >= b.radius && b.gravity > 0 && b.contact.damping > 0 &&
           b.contact.law == ContactLaw::slides &&
           damping_ratio(b.contact.stiffness, b.contact.damping, b.mass) < 0.99;
  };
  std::vector<State<double>> states(balls.size());
  std::size_t i = 0;
  for (; i + lanes::count <= balls.size(); i += lanes::count) {
    const SweepBall* group = &balls[i];
    if (!std::all_of(group, group + lanes::count, is_usual)) break;
    lanes::Last first;
    for (int lane = 0; lane < lanes::count; ++lane) {
      const SweepBall& b = group[lane];
      const double height = b.start.position - b.radius;
      const double speed = impact_speed(height, b.start.velocity, b.gravity);
      first.touch_start[lane] = time_to_fall(height, b.start.velocity, b.gravity, speed);
      first.touch_speed[lane] = speed;
      first.flight_start[lane] = -1;  // the first flight does not begin at the floor
      first.flight_speed[lane] = 0;
    }
    const lanes::Last last = lanes::walk(group, first, t);
    for (int lane = 0; lane < lanes::count; ++lane) {
      const SweepBall& b = group[lane];
      State<double>& state = states[i + static_cast<std::size_t>(lane)];
      if (last.touches[lane] > 0) {
        state = phases_of(b).move(Phase::touch, {b.radius, -last.touch_speed[lane]},
                                  t - last.touch_start[lane]);
      } else if (last.flight_start[lane] >= 0) {
        state = fly({b.radius, last.flight_speed[lane]}, b.gravity, t - last.flight_start[lane]);
      } else {
        state = fly(b.start, b.gravity, t);
      }
    }
  }
  for (; i < balls.size(); ++i) {
    states[i] = EventDriven<BouncePhases>(phases_of(balls[i]), 0, balls[i].start).at(t);
  }
  return states;
}

}  // namespace bounce
