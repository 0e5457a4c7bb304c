#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "06_oscillating_floor/exact/contact_bounds.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "physics/events/first_zero.hpp"

namespace bounce {

/// Stage 6 in closed form, for all three floor laws. In flight the ball follows a parabola; in
/// contact it is an oscillator that the floor shakes. When a phase ends is not known by formula:
/// it is the first zero of the gap between ball and floor, or of the contact force, and the search
/// (first_zero.hpp) skips none, because it knows bounds on how fast these can change.
class OscillatingFloorExact {
 public:
  explicit OscillatingFloorExact(const OscillatingFloor& scene)
      : scene_(scene),
        contact_(scene),
        switched_(scene.floor_law == FloorLaw::fixed_switch),
        clamped_(scene.contact == ContactLaw::push_only && (scene.damping > 0 || switched_)) {}

  /// A phase begins at `t`; the times below count from here.
  void begin(double t) { contact_.begin(t); }

  Phase phase_at(const State<double>& state) const {
    const FloorMovement floor = contact_.floor.at_start();
    if (!(gap(floor, state) < 0)) return Phase::flight;
    return clamped_ && contact_.push(floor, state) <= 0 ? Phase::let_go : Phase::touch;
  }

  State<double> move(Phase phase, const State<double>& start, double t) const {
    return phase == Phase::touch ? contact_.ball_at(start, t, contact_.floor.turn(t))
                                 : fly(start, scene_.gravity, t);
  }
  PhaseEnd end_of(Phase phase, const State<double>& start) const {
    return phase == Phase::flight ? end_of_flight(start) : end_of_contact(phase, start);
  }

  /// At a touch and at a lift-off the ball's height is known exactly.
  State<double> at_event(Phase before, Phase after, State<double> state) const {
    if (before == after) return state;
    if (before == Phase::flight || after == Phase::flight) {
      state.position = scene_.radius + edge(contact_.floor.at_start()).height;
    }
    return state;
  }

  /// A ball can hover on the edge of a contact that pushes while gravity pulls it back in
  /// (`fixed-switch` and `absolute` do this): ever shorter hops, and no end. A thousand such hops
  /// in a row, each shorter than this, stop the run.
  double shortest_phase() const { return 1e-3 / std::max(contact_.omega0, contact_.w); }

  // ---- For methods that step but locate events (located_events.hpp)

  /// The law of a phase, smooth across its end [m/s^2].
  double acceleration(Phase phase, double t, const State<double>& state) const {
    return phase == Phase::touch ? contact_.acceleration(contact_.floor.at(t), state)
                                 : -scene_.gravity;
  }
  /// What can come after a touch. A contact that only pushes and knows the floor's speed lets go
  /// before it opens.
  std::span<const Phase> after_touch() const {
    static constexpr Phase all[] = {Phase::flight, Phase::let_go};
    return std::span(all).subspan(clamped_ && contact_.relative ? 1 : 0,
                                  clamped_ && !contact_.relative ? 2 : 1);
  }
  /// What tells that a touch does not yet give way to `next`: the overlap, or the force.
  EventValue event_value(Phase next, double t, const State<double>& state) const {
    const FloorMovement floor = contact_.floor.at(t);
    if (next == Phase::flight) return {-gap(floor, state), edge(floor).speed - state.velocity};
    const double a = contact_.acceleration(floor, state);
    return {contact_.push(floor, state), scene_.mass * contact_.jerk(floor, state, a)};
  }
  /// A bound on that function's second derivative for the next `window` seconds.
  double max_bend(Phase next, double t, const State<double>& state, double window) const {
    const Complex turned = contact_.floor.turn(t);
    const ContactNow now =
        contact_at(contact_, t, state, turned, window, contact_.free_part(state, t, turned), 0);
    return (next == Phase::let_go ? push_in_touch(now) : overlap_in_touch(now)).max_bend;
  }
  /// The fastest that happens in a touch takes about this long [s].
  double time_scale() const { return 1 / (contact_.omega0 + 2 * contact_.beta + contact_.w); }

 private:
  /// What the ball has to come down to: the floor, or the slides' switch, which stands still.
  FloorMovement edge(const FloorMovement& floor) const {
    return switched_ ? FloorMovement{} : floor;
  }
  double top_acceleration_of_edge() const {
    return switched_ ? 0 : contact_.floor.top_acceleration();
  }
  /// The ball is in contact while this is negative [m].
  double gap(const FloorMovement& floor, const State<double>& state) const {
    return state.position - edge(floor).height - scene_.radius;
  }

  // ---- Flight (and let go: the ball overlaps, but nothing acts on it)

  BoundedValue gap_in_flight(const State<double>& start, double t) const {
    const State<double> ball = fly(start, scene_.gravity, t);
    const FloorMovement floor = edge(contact_.floor.at(t));
    const double most = top_acceleration_of_edge();
    return {gap(floor, ball), ball.velocity - floor.speed, -scene_.gravity - floor.acceleration,
            scene_.gravity + most, most * contact_.w};
  }

  // push = k (r - y + h) - c (v - h'), with y'' = -g; without the h' where the damper is absolute.
  BoundedValue push_in_flight(const State<double>& start, double t) const {
    const double k = scene_.stiffness, c = scene_.damping, g = scene_.gravity;
    const double c_floor = contact_.relative ? c : 0;
    const State<double> ball = fly(start, g, t);
    const FloorMovement floor = contact_.floor.at(t);
    const double most = contact_.floor.top_acceleration(), most_jerk = most * contact_.w;
    return {contact_.push(floor, ball),
            k * (floor.speed - ball.velocity) + c * g + c_floor * floor.acceleration,
            k * (floor.acceleration + g) + c_floor * floor.jerk,
            k * (most + g) + c_floor * most_jerk, k * most_jerk + c_floor * most_jerk * contact_.w};
  }

  PhaseEnd end_of_flight(const State<double>& start) const {
    // Nothing is touched above the highest point of the swing: fall there by formula.
    const double highest = switched_ ? 0 : contact_.floor.steady_height() + scene_.amplitude;
    const double above = start.position - scene_.radius - highest;
    double t = 0;
    if (above > 0) {
      const double falling = start.velocity - (switched_ ? 0 : scene_.floor_velocity);
      t = time_to_fall(above, falling, scene_.gravity);
      if (t == never) return {never, Phase::touch};
    }
    const auto gap_at = [&](double s) { return gap_in_flight(start, s); };
    const FirstZero touch = first_zero(gap_at, t, never, patience);
    if (!touch.found) return {touch.t, Phase::flight};
    if (!clamped_ || contact_.relative) return {touch.t, Phase::touch};
    // A damper that does not know the floor's speed may have to pull from the first moment on.
    const double first_push =
        contact_.push(contact_.floor.at(touch.t), fly(start, scene_.gravity, touch.t));
    return {touch.t, first_push > 0 ? Phase::touch : Phase::let_go};
  }

  // ---- Contact

  BoundedValue overlap_in_touch(const ContactNow& now) const {
    const FloorMovement floor = edge(now.floor);
    const double most = top_acceleration_of_edge();
    return {-gap(floor, now.ball),
            floor.speed - now.ball.velocity,
            floor.acceleration - now.acceleration,
            now.max[0] + most,
            now.max[1] + contact_.w * most,
            now.window};
  }

  BoundedValue push_in_touch(const ContactNow& now) const {
    const double k = scene_.stiffness, c = scene_.damping, m = scene_.mass;
    const double bend = k * (now.floor.acceleration - now.acceleration) -
                        c * (now.jerk - (contact_.relative ? now.floor.jerk : 0));
    return {m * (now.acceleration + scene_.gravity),
            m * now.jerk,
            bend,
            m * now.max[2],
            m * now.max[3],
            now.window};
  }

  /// Does the ball stay in contact for ever? When steady and free swing together cannot open the
  /// contact, it never opens. Under a very small weight the free swing is soon lost in the rounding
  /// of the heights: what is smaller than that does not count.
  bool stays(const State<double>& start) const {
    const double u = scene_.floor_velocity, omega0 = contact_.omega0, w = contact_.w;
    State<double> free = contact_.free_part(start, 0, 1);
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() *
        (std::abs(start.position) + std::abs(contact_.rest_height()) + contact_.steady_size);
    if (std::hypot(free.position, free.velocity / omega0) < rounding) free = {0, 0};
    const double free_swing = std::hypot(free.position, free.velocity / omega0);
    const double free_a = free_acceleration(contact_, free);

    // What acts on the floor's speed, too:
    const double c_unknown = contact_.relative ? 0 : scene_.damping;
    // How far the spring is pressed in on average, and how much that swings. Both are written
    // without a difference of heights, in which a small weight would be lost.
    double pressed = contact_.sag + c_unknown * u / scene_.stiffness;
    Complex swing =
        contact_.floor.swing() * contact_.answer * Complex(w * w, -w * c_unknown / scene_.mass);
    if (switched_) {
      if (u > 0) return false;  // the ball rides up, and out of the switch
      pressed -= contact_.floor.steady_height();
      swing = contact_.steady;
    }
    const bool overlaps = std::abs(swing) + free_swing < pressed;
    const bool pushes = w * w * contact_.steady_size + free_a < scene_.gravity;
    return overlaps && (pushes || !clamped_);
  }

  PhaseEnd end_of_contact(Phase phase, const State<double>& start) const {
    const bool touching = phase == Phase::touch;
    if (touching && stays(start)) return {never, Phase::flight};

    const Phase other = touching ? Phase::let_go : Phase::touch;
    FirstZero opens{never, false}, changes{never, false};
    // A contact that only pushes and knows the floor's speed lets go before it opens.
    if (!(touching && clamped_ && contact_.relative)) {
      const auto overlap = [&](double t) {
        return touching ? overlap_in_touch(contact_at(contact_, start, t))
                        : -gap_in_flight(start, t);
      };
      opens = first_zero(overlap, 0, never, patience);
    }
    if (clamped_) {
      const auto change = [&](double t) {
        return touching ? push_in_touch(contact_at(contact_, start, t)) : -push_in_flight(start, t);
      };
      changes = first_zero(change, 0, opens.t, patience);
    }
    if (opens.t <= changes.t) return {opens.t, opens.found ? Phase::flight : phase};
    return {changes.t, changes.found ? other : phase};
  }

  static constexpr int patience = 200;  // steps of a search; then it goes on as a phase of its own

  OscillatingFloor scene_;
  ShakenContact contact_;
  bool switched_;  // the slides' switch: contact below y = r, wherever the floor is
  bool clamped_;   // push-only, where that makes a difference
};

}  // namespace bounce
