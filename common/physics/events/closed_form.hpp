#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "physics/contact.hpp"
#include "physics/events/damped_oscillator.hpp"
#include "physics/events/event_value.hpp"
#include "physics/state.hpp"

namespace bounce {

// ---- Flight -------------------------------------------------------------------------------------

/// Free flight for `t` seconds under gravity [m/s^2, positive, downwards]:
/// y'' = -g  has the solution  v(t) = v0 - g t,  y(t) = y0 + v0 t - g t^2 / 2.
inline State<double> fly(const State<double>& start, double gravity, double t) {
  return {start.position + (start.velocity - gravity * t / 2) * t, start.velocity - gravity * t};
}

/// The same in space, where the acceleration [m/s^2] is a vector.
template <class Vector>
State<Vector> fly(const State<Vector>& start, const Vector& acceleration, double t) {
  return {start.position + (start.velocity + acceleration * (t / 2)) * t,
          start.velocity + acceleration * t};
}

/// How fast a ball comes down to the touch [m/s] that is `height` >= 0 above it and flies with
/// `velocity`. Negative when it never gets there: gravity may be negative and pull away from the
/// touch (an overhanging plane).
inline double impact_speed(double height, double velocity, double gravity) {
  if (height == 0) return std::abs(velocity);
  const double squared = velocity * velocity + 2 * gravity * height;
  return squared >= 0 ? std::sqrt(squared) : -1;
}

/// When that ball comes down [s], knowing how fast: the first positive root of
/// height + v t - g t^2 / 2 = 0, in the form that subtracts nothing.
inline double time_to_fall(double height, double velocity, double gravity, double impact_speed) {
  if (impact_speed < 0) return never;
  if (velocity > 0) return gravity > 0 ? (velocity + impact_speed) / gravity : never;
  return impact_speed - velocity > 0 ? 2 * height / (impact_speed - velocity)
                                     : (height > 0 || !(gravity > 0) ? never : 0);
}
inline double time_to_fall(double height, double velocity, double gravity) {
  return time_to_fall(height, velocity, gravity, impact_speed(height, velocity, gravity));
}

// ---- A ball on a spring floor, phase by phase ---------------------------------------------------

enum class Phase {
  flight,  // above the floor
  touch,   // spring and damper act
  let_go   // push-only: still overlapping, but the contact would have to pull, so it does nothing
};

/// How a phase ends: after how long [s] (`never` for a ball that stays), what comes next, and where
/// the ball then is and how fast. The search for the end finds that on its way.
struct PhaseEnd {
  double after;
  Phase next;
  State<double> arrival = {never, 0};  // filled in by BouncePhases only
};

/// Each phase of a ball above a level floor at height 0, in closed form. It serves every stage in
/// which a ball meets one fixed surface; EventDriven (event_driven.hpp) walks through the phases.
class BouncePhases {
 public:
  /// [kg], [m/s^2] towards the floor (negative where it pulls away: stage 7), [m]
  BouncePhases(double mass, double gravity, double radius, const SpringDamper& contact)
      : mass_(mass),
        gravity_(gravity),
        radius_(radius),
        contact_(contact),
        omega0_(natural_frequency(contact.stiffness, mass)),
        sag_(mass * gravity / contact.stiffness),
        oscillator_(omega0_, contact.damping / (2 * mass)) {}

  Phase phase_at(const State<double>& state) const {
    const double overlap = radius_ - state.position;
    if (!(overlap > 0)) return Phase::flight;
    return contact_.law == ContactLaw::push_only && contact_.force(overlap, state.velocity) <= 0
               ? Phase::let_go
               : Phase::touch;
  }

  State<double> move(Phase phase, const State<double>& start, double t) const {
    if (phase != Phase::touch) return fly(start, gravity_, t);
    const State<double> gap{start.position - radius_, start.velocity};
    const State<double> moved = oscillator_.move(gap, t, -gravity_);
    return {radius_ + moved.position, moved.velocity};
  }

  PhaseEnd end_of(Phase phase, const State<double>& start) const {
    if (phase == Phase::flight) return end_of_flight(start);
    return phase == Phase::touch ? end_of_touch(start) : end_of_let_go(start);
  }

  /// The state at that end: as move(), but without computing it a second time.
  State<double> arrive(const State<double>& /*start*/, const PhaseEnd& end) const {
    return end.arrival;
  }

  /// At a touch and at a lift-off the height is known exactly.
  State<double> at_event(Phase before, Phase after, State<double> state) const {
    if (before == Phase::flight || after == Phase::flight) state.position = radius_;
    return state;
  }

  // ---- For methods that step but locate events (located_events.hpp)

  /// The law of a phase, smooth across its end [m/s^2]. Nothing here depends on the time.
  double acceleration(Phase phase, double /*t*/, const State<double>& state) const {
    if (phase != Phase::touch) return -gravity_;
    return oscillator_.acceleration(from_rest_height(state));
  }

  /// What can come after a touch.
  std::array<Phase, 1> after_touch() const {
    const bool until_parted = contact_.law == ContactLaw::may_pull || contact_.damping == 0;
    return {until_parted ? Phase::flight : Phase::let_go};
  }
  /// What tells that a touch does not yet give way to `next`: the overlap, or, for a contact that
  /// only pushes, its force.
  EventValue event_value(Phase next, double t, const State<double>& state) const {
    const double overlap = radius_ - state.position, v = state.velocity;
    if (next == Phase::flight) return {overlap, -v};
    const double k = contact_.stiffness, c = contact_.damping;
    return {k * overlap - c * v, -k * v - c * acceleration(Phase::touch, t, state)};
  }

  /// The fastest that happens in a touch takes about this long [s].
  double time_scale() const { return 1 / (omega0_ + contact_.damping / mass_); }

  /// A bound on the second derivative of that function, from now to the touch's end. Overlap and
  /// force are solutions x of the oscillator, plus a constant; v^2 + omega0^2 x^2 never grows.
  double max_bend(Phase next, double /*t*/, const State<double>& state, double /*window*/) const {
    const State<double> x = from_rest_height(state);
    return oscillator_.largest_acceleration(next == Phase::flight ? x : pull(x));
  }

 private:
  /// k x + c x', the force but for the weight, and its rate.
  State<double> pull(const State<double>& x) const {
    const double k = contact_.stiffness, c = contact_.damping;
    return {k * x.position + c * x.velocity, k * x.velocity + c * oscillator_.acceleration(x)};
  }
  State<double> from_rest_height(const State<double>& state) const {
    return {state.position - radius_ + sag_, state.velocity};
  }
  PhaseEnd end_of_flight(const State<double>& start) const;
  PhaseEnd end_of_touch(const State<double>& start) const;
  PhaseEnd end_of_let_go(const State<double>& start) const;

  double mass_;
  double gravity_;
  double radius_;
  SpringDamper contact_;
  double omega0_;  // rad/s
  double sag_;     // m: how far the weight alone presses the spring in
  DampedOscillator oscillator_;
};

inline PhaseEnd BouncePhases::end_of_flight(const State<double>& start) const {
  const double height = std::max(0.0, start.position - radius_);
  const double speed = impact_speed(height, start.velocity, gravity_);
  return {time_to_fall(height, start.velocity, gravity_, speed), Phase::touch, {radius_, -speed}};
}

inline PhaseEnd BouncePhases::end_of_touch(const State<double>& start) const {
  const double k = contact_.stiffness, c = contact_.damping, v = start.velocity;
  if (c == 0 && start.position == radius_ && v < 0) {
    // An undamped contact is its own mirror image in time: the ball leaves as fast as it came.
    // Every touch but a run's first begins here, at overlap 0. (The C library's atan takes less
    // than half the instructions of its atan2, and that was most of a bounce.)
    const double swing = std::numbers::pi + 2 * std::atan(omega0_ * sag_ / -v);
    return {swing / omega0_, Phase::flight, {radius_, -v}};
  }
  const State<double> x = from_rest_height(start);
  if (contact_.law == ContactLaw::may_pull || c == 0) {
    const Crossing out = oscillator_.rise(x, sag_);
    return {out.t, Phase::flight, {radius_, out.velocity}};
  }
  // The force is m g - (k x + c x'). The bracket, a sum of solutions of the oscillator, is itself
  // a solution: so the force is gone when *that* oscillator has risen to the weight.
  const Crossing gone = oscillator_.rise(pull(x), mass_ * gravity_);
  // Then x'' = -g, and pull' = k x' - c g tells the velocity; spring and damper are in balance.
  const double velocity = (gone.velocity + c * gravity_) / k;
  return {gone.t, Phase::let_go, {radius_ - c * velocity / k, velocity}};
}

inline PhaseEnd BouncePhases::end_of_let_go(const State<double>& start) const {
  const double k = contact_.stiffness, c = contact_.damping;
  const double g = gravity_, v = start.velocity;
  const double overlap = radius_ - start.position;
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
  const double after = std::min(out, again);
  return {after, out <= again ? Phase::flight : Phase::touch, fly(start, g, after)};
}

}  // namespace bounce
