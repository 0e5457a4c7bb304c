#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact.hpp"
#include "physics/state.hpp"

namespace bounce {

inline constexpr double never = std::numeric_limits<double>::infinity();

// ---- Flight -------------------------------------------------------------------------------------

/// Free flight for `t` seconds under gravity [m/s^2, positive, downwards]:
/// y'' = -g  has the solution  v(t) = v0 - g t,  y(t) = y0 + v0 t - g t^2 / 2.
inline State<double> fly(const State<double>& start, double gravity, double t) {
  return {start.position + (start.velocity - gravity * t / 2) * t, start.velocity - gravity * t};
}

/// When a ball at `height` >= 0 above the touch, flying with `velocity`, comes down to it [s]:
/// the first positive root of height + v t - g t^2 / 2 = 0, in the form that subtracts nothing.
/// Negative gravity pulls away from the touch (an overhanging plane): a slow ball never gets there.
inline double time_to_fall(double height, double velocity, double gravity) {
  const double reserve = velocity * velocity + 2 * gravity * height;
  if (reserve < 0) return never;
  const double impact_speed = std::sqrt(reserve);
  if (velocity > 0) return gravity > 0 ? (velocity + impact_speed) / gravity : never;
  return impact_speed - velocity > 0 ? 2 * height / (impact_speed - velocity)
                                     : (height > 0 ? never : 0);
}

// ---- Touch --------------------------------------------------------------------------------------

/// The damped oscillator x'' + 2 beta x' + omega0^2 x = 0, solved by formula in all three regimes.
/// With the discriminant D = omega0^2 - beta^2 and its root w = sqrt(|D|):
///   under-damped  (D > 0)  cosine and sine of w t under the envelope exp(-beta t)
///   over-damped   (D < 0)  two exponentials with the rates beta - w and beta + w
///   critical      (D = 0)  the common limit of both: exp(-beta t) times a straight line.
/// The formulas are written so that nothing cancels near D = 0 nor for a very strong damper.
class DampedOscillator {
 public:
  DampedOscillator(double omega0, double beta)  // [rad/s], [1/s]
      : omega0_squared_(omega0 * omega0),
        beta_(beta),
        discriminant_((omega0 - beta) * (omega0 + beta)),
        w_(std::sqrt(std::abs(discriminant_))),
        fast_(beta + w_),
        slow_(omega0_squared_ / fast_) {}

  /// Position [m] and velocity [m/s] after `t` seconds.
  State<double> move(const State<double>& start, double t) const;

  /// The first moment after 0 at which the velocity is zero [s], or `never`.
  double turning_time(const State<double>& start) const;

  /// The first moment at which x comes up through `level` [s], or `never`. Needs a start at or
  /// below `level`. Between two turning points x is monotone, and the first top is the highest: so
  /// the one bracket that matters is known, and no crossing can be missed.
  double rise_time(const State<double>& start, double level) const;

 private:
  double omega0_squared_;
  double beta_;
  double discriminant_;
  double w_;
  double fast_;  // beta + w: the faster rate of an over-damped movement
  double slow_;  // beta - w, without the cancellation
};

// The formulas are inline: the exact solution is made of nothing else.

inline State<double> DampedOscillator::move(const State<double>& start, double t) const {
  // x(t) = x0 (C + beta S) + v0 S,  v(t) = v0 (C - beta S) - omega0^2 x0 S, where S(t) answers a
  // kick: S(0) = 0, S'(0) = 1; and C = S' + beta S.
  double S, C_plus, C_minus;
  if (discriminant_ > 0) {
    const double envelope = std::exp(-beta_ * t);
    S = envelope * std::sin(w_ * t) / w_;
    const double C = envelope * std::cos(w_ * t);
    C_plus = C + beta_ * S;
    C_minus = C - beta_ * S;
  } else {
    const double envelope = std::exp(-slow_ * t);
    const double lead = w_ > 0 ? -std::expm1(-2 * w_ * t) / (2 * w_) : t;
    S = envelope * lead;
    C_plus = envelope * (1 + slow_ * lead);
    C_minus = w_ * t > 0.5 ? envelope * (fast_ * std::exp(-2 * w_ * t) - slow_) / (2 * w_)
                           : envelope * (1 - fast_ * lead);
  }
  return {start.position * C_plus + start.velocity * S,
          start.velocity * C_minus - omega0_squared_ * start.position * S};
}

inline double DampedOscillator::turning_time(const State<double>& start) const {
  const double v = start.velocity;
  const double push = omega0_squared_ * start.position;
  if (discriminant_ > 0) {
    const double angle = std::atan2(w_ * v, beta_ * v + push);  // tan(w t) = w v / (beta v + push)
    return (angle > 0 ? angle : angle + std::acos(-1.0)) / w_;
  }
  const double ratio = (slow_ * v + push) / (fast_ * v + push);  // = exp(-2 w t)
  const double lead = v / (fast_ * v + push);
  if (!(ratio > 0) || !(lead > 0)) return never;
  if (w_ == 0) return lead;
  return 2 * w_ * lead < 0.5 ? -std::log1p(-2 * w_ * lead) / (2 * w_) : -std::log(ratio) / (2 * w_);
}

inline double DampedOscillator::rise_time(const State<double>& start, double level) const {
  if (start.position >= level && start.velocity > 0) return 0;
  double low = 0;  // a moment from which on x rises
  double high;     // the top after it
  if (start.velocity > 0 || (start.velocity == 0 && start.position < 0)) {
    high = turning_time(start);
  } else {
    low = turning_time(start);
    if (low == never) return never;
    high = discriminant_ > 0 ? low + std::acos(-1.0) / w_ : never;
  }
  if (high == never) {  // it creeps up towards 0 and never reaches it
    if (level >= 0) return never;
    high = low + 1 / slow_;
    while (move(start, high).position < level) high = low + 2 * (high - low);
  }
  if (move(start, high).position < level) return never;

  // Newton's method, kept inside the bracket by bisection.
  double t = (low + high) / 2;
  for (int i = 0; i < 100; ++i) {
    const State<double> now = move(start, t);
    const double miss = now.position - level;
    (miss < 0 ? low : high) = t;
    double next = t - miss / now.velocity;
    if (!(low < next && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) <= 2 * std::numeric_limits<double>::epsilon() * t) return next;
    t = next;
  }
  return t;
}

// ---- A ball on a spring floor, phase by phase ---------------------------------------------------

enum class Phase {
  flight,  // above the floor
  touch,   // spring and damper act
  let_go   // push-only: still overlapping, but the contact would have to pull, so it does nothing
};

/// How a phase ends: after how long [s] (`never` for a ball that stays), and what comes next.
struct PhaseEnd {
  double after;
  Phase next;
};

/// Each phase of a ball above a level floor at height 0, in closed form. It serves every stage in
/// which a ball meets one fixed surface; EventDriven (event_driven.hpp) walks through the phases.
struct BouncePhases {
  double mass;     // kg
  double gravity;  // m/s^2, towards the floor; negative where it pulls away (stage 7)
  double radius;   // m
  SpringDamper contact;

  Phase phase_at(const State<double>& state) const {
    const double overlap = radius - state.position;
    if (!(overlap > 0)) return Phase::flight;
    return contact.law == ContactLaw::push_only && contact.force(overlap, state.velocity) <= 0
               ? Phase::let_go
               : Phase::touch;
  }

  State<double> move(Phase phase, const State<double>& start, double t) const {
    if (phase != Phase::touch) return fly(start, gravity, t);
    const State<double> moved = oscillator().move(from_rest_height(start), t);
    return {rest_height() + moved.position, moved.velocity};
  }

  PhaseEnd end_of(Phase phase, const State<double>& start) const {
    switch (phase) {
      case Phase::flight:
        return {time_to_fall(std::max(0.0, start.position - radius), start.velocity, gravity),
                Phase::touch};
      case Phase::touch:
        return end_of_touch(start);
      case Phase::let_go:
        break;
    }
    return end_of_let_go(start);
  }

  /// At a touch and at a lift-off the height is known exactly.
  State<double> at_event(Phase before, Phase after, State<double> state) const {
    if (before == Phase::flight || after == Phase::flight) state.position = radius;
    return state;
  }

 private:
  double sag() const { return mass * gravity / contact.stiffness; }
  double rest_height() const { return radius - sag(); }
  double beta() const { return contact.damping / (2 * mass); }
  DampedOscillator oscillator() const {
    return {natural_frequency(contact.stiffness, mass), beta()};
  }
  State<double> from_rest_height(const State<double>& state) const {
    return {state.position - radius + sag(), state.velocity};
  }
  PhaseEnd end_of_touch(const State<double>& start) const;
  PhaseEnd end_of_let_go(const State<double>& start) const;
};

inline PhaseEnd BouncePhases::end_of_touch(const State<double>& start) const {
  const State<double> x = from_rest_height(start);
  const double k = contact.stiffness, c = contact.damping;
  if (contact.law == ContactLaw::slides || c == 0) {
    return {oscillator().rise_time(x, sag()), Phase::flight};
  }
  // The force is m g - (k x + c x'). The bracket, a sum of solutions of the oscillator, is itself
  // a solution: so the force is gone when *that* oscillator has risen to the weight.
  const double acceleration = -k / mass * x.position - c / mass * x.velocity;
  const State<double> pull{k * x.position + c * x.velocity, k * x.velocity + c * acceleration};
  return {oscillator().rise_time(pull, mass * gravity), Phase::let_go};
}

inline PhaseEnd BouncePhases::end_of_let_go(const State<double>& start) const {
  const double k = contact.stiffness, c = contact.damping;
  const double g = gravity, v = start.velocity;
  const double overlap = radius - start.position;
  // Out of the floor: overlap = v t - g t^2 / 2, the first root.
  const double reserve = v * v - 2 * g * overlap;
  const double out = v > 0 && reserve >= 0 ? 2 * overlap / (v + std::sqrt(reserve)) : never;
  // Pushed again: k overlap(t) - c v(t) = F + (c g - k v) t + (k g / 2) t^2 comes up through zero.
  const double F = std::min(0.0, k * overlap - c * v);
  const double slope = c * g - k * v;
  const double root = std::sqrt(slope * slope - 2 * k * g * F);
  double again = never;
  if (slope > 0) again = -2 * F / (slope + root);
  if (slope <= 0 && g > 0) again = (root - slope) / (k * g);
  return out <= again ? PhaseEnd{out, Phase::flight} : PhaseEnd{again, Phase::touch};
}

}  // namespace bounce
