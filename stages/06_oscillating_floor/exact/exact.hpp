#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <span>

#include "06_oscillating_floor/exact/forced_oscillator.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "physics/events/closed_form.hpp"
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
        w_(scene.angular_frequency),
        sag_(scene.mass * scene.gravity / scene.stiffness),
        omega0_(natural_frequency(scene.stiffness, scene.mass)),
        beta_(scene.damping / (2 * scene.mass)),
        relative_(scene.floor_law == FloorLaw::relative),
        switched_(scene.floor_law == FloorLaw::fixed_switch),
        clamped_(scene.contact == ContactLaw::push_only && (scene.damping > 0 || switched_)),
        oscillator_(omega0_, beta_, w_) {
    // At resonance without a damper there is no steady answer. One rounding beside it, it is huge,
    // and bounds nothing: the search then goes by the other bound.
    const double detuning = (omega0_ - w_) * (omega0_ + w_);
    const double least = std::numeric_limits<double>::epsilon() * omega0_ * omega0_;
    answer_ = 1.0 / Complex(detuning != 0 ? detuning : least, 2 * beta_ * w_);
    begin(0);
    shaking_size_ = std::abs(shaking_);
    steady_size_ = std::abs(steady_);
  }

  /// A phase begins at `t`; the times below count from here. The angle of the floor's swing is
  /// reduced to one turn, once: after hours w t is so large that its rounding would be all that the
  /// search for a zero sees.
  void begin(double t) {
    const double angle = w_ * t + scene_.phase;
    swing_ = scene_.amplitude * Complex(std::cos(angle), std::sin(angle));  // these reduce exactly
    height_ = scene_.floor_velocity * t;
    shaking_ =
        Complex(scene_.stiffness, relative_ ? scene_.damping * w_ : 0) * swing_ / scene_.mass;
    steady_ = shaking_ * answer_;
  }

  Phase phase_at(const State<double>& state) const {
    const Floor floor = floor_at_start();
    if (!(gap(floor, state) < 0)) return Phase::flight;
    return clamped_ && push(floor, state) <= 0 ? Phase::let_go : Phase::touch;
  }

  State<double> move(Phase phase, const State<double>& start, double t) const;
  PhaseEnd end_of(Phase phase, const State<double>& start) const;

  /// At a touch and at a lift-off the ball's height is known exactly.
  State<double> at_event(Phase before, Phase after, State<double> state) const {
    if (before == after) return state;
    if (before == Phase::flight || after == Phase::flight) {
      state.position = scene_.radius + (switched_ ? 0 : floor_at_start().height);
    }
    return state;
  }

  /// A ball can hover on the edge of a contact that pushes while gravity pulls it back in
  /// (`fixed-switch` and `absolute` do this): ever shorter hops, and no end. A thousand such hops
  /// in a row, each shorter than this, stop the run.
  double shortest_phase() const { return 1e-3 / std::max(omega0_, w_); }

  // ---- For methods that step but locate events (located_events.hpp)

  /// The law of a phase, smooth across its end [m/s^2].
  double acceleration(Phase phase, double t, const State<double>& state) const {
    return phase == Phase::touch ? acceleration_in_touch(floor_at(t), state) : -scene_.gravity;
  }
  /// What can come after a touch. A contact that only pushes and knows the floor's speed lets go
  /// before it opens.
  std::span<const Phase> after_touch() const {
    static constexpr Phase all[] = {Phase::flight, Phase::let_go};
    return std::span(all).subspan(clamped_ && relative_ ? 1 : 0, clamped_ && !relative_ ? 2 : 1);
  }
  /// What tells that a touch does not yet give way to `next`: the overlap, or the force.
  Lasting touch_lasts(Phase next, double t, const State<double>& state) const;
  /// A bound on that function's second derivative for the next `window` seconds.
  double max_bend(Phase next, double t, const State<double>& state, double window) const;
  /// The fastest that happens in a touch takes about this long [s].
  double time_scale() const { return 1 / (omega0_ + 2 * beta_ + w_); }

 private:
  /// The floor's height [m] and its first three derivatives.
  struct Floor {
    double height, speed, acceleration, jerk;
  };
  Complex turn(double t) const { return {std::cos(w_ * t), std::sin(w_ * t)}; }
  Floor floor_at(double t, Complex turned) const {
    const Complex swing = swing_ * turned;
    const double sine = swing.imag(), cosine = swing.real();
    return {height_ + scene_.floor_velocity * t + sine, scene_.floor_velocity + w_ * cosine,
            -w_ * w_ * sine, -w_ * w_ * w_ * cosine};
  }
  Floor floor_at(double t) const { return floor_at(t, turn(t)); }
  Floor floor_at_start() const { return floor_at(0, 1); }

  /// The ball is in contact while this is negative [m].
  double gap(const Floor& floor, const State<double>& state) const {
    return state.position - (switched_ ? 0 : floor.height) - scene_.radius;
  }
  /// Spring and damper together [N]; a contact that only pushes acts while this is positive.
  double push(const Floor& floor, const State<double>& state) const {
    const double damped = state.velocity - (relative_ ? floor.speed : 0);
    return scene_.stiffness * (scene_.radius - state.position + floor.height) -
           scene_.damping * damped;
  }

  double acceleration_in_touch(const Floor& floor, const State<double>& state) const {
    return push(floor, state) / scene_.mass - scene_.gravity;
  }
  /// Its rate [m/s^3].
  double jerk_in_touch(const Floor& floor, const State<double>& state, double a) const {
    return (scene_.stiffness * (floor.speed - state.velocity) -
            scene_.damping * (a - (relative_ ? floor.acceleration : 0))) /
           scene_.mass;
  }

  Glimpse gap_in_flight(const State<double>& start, double t) const;
  Glimpse push_in_flight(const State<double>& start, double t) const;
  struct Touch;  // what gap and push need to know of the movement in contact
  Touch touch_at(double t, const State<double>& ball, Complex turned, double window,
                 const State<double>& free_before, double since) const;
  Touch touch_at(const State<double>& start, double t) const;
  Glimpse overlap_in_touch(const State<double>& start, double t) const;
  Glimpse push_in_touch(const State<double>& start, double t) const;
  State<double> free_part(const State<double>& ball, double t, Complex turned) const;
  double free_acceleration(const State<double>& free) const;
  std::array<double, 4> free_bounds(const State<double>& free, const State<double>& before,
                                    double since) const;
  bool stays(const State<double>& start) const;

  PhaseEnd end_of_flight(const State<double>& start) const;
  PhaseEnd end_of_contact(Phase phase, const State<double>& start) const;

  // The height that the spring would hold above the steadily moving floor: the oscillator swings
  // about it. An absolute damper under a moving floor weighs c u more.
  double rest_height() const {
    const double pressed = relative_ ? 0 : scene_.damping * scene_.floor_velocity;
    return height_ + scene_.radius - sag_ - pressed / scene_.stiffness;
  }
  State<double> ball_in_touch(const State<double>& start, double t, Complex turned) const {
    const double rest = rest_height(), u = scene_.floor_velocity;
    const State<double> x =
        oscillator_.move({start.position - rest, start.velocity - u}, shaking_, t, turned);
    return {rest + u * t + x.position, u + x.velocity};
  }

  static constexpr int patience = 200;  // steps of a search; then it goes on as a phase of its own

  OscillatingFloor scene_;
  double w_;       // rad/s, of the floor
  double sag_;     // m, of the spring under the ball's weight
  double omega0_;  // rad/s, of the ball on the spring
  double beta_;    // 1/s
  bool relative_;  // the damper knows the floor's speed
  bool switched_;  // the slides' switch: contact below y = r, wherever the floor is
  bool clamped_;   // push-only, where that makes a difference
  ForcedOscillator oscillator_;
  Complex answer_;           // steady / shaking [s^2]
  double shaking_size_ = 0;  // m/s^2
  double steady_size_ = 0;   // m
  // When the phase began:
  double height_ = 0;  // m, of the floor's steady movement
  Complex swing_;      // the floor's swing is Im(swing e^(i w t)) [m],
  Complex shaking_;    // what the oscillator feels of it, Im(shaking e^(i w t)) [m/s^2],
  Complex steady_;     // and its steady answer, Im(steady e^(i w t)) [m]; huge at resonance
};

// ---- Movement -----------------------------------------------------------------------------------

inline State<double> OscillatingFloorExact::move(Phase phase, const State<double>& start,
                                                 double t) const {
  return phase == Phase::touch ? ball_in_touch(start, t, turn(t)) : fly(start, scene_.gravity, t);
}

// ---- Flight (and let go: the ball overlaps, but nothing acts on it) -----------------------------

inline Glimpse OscillatingFloorExact::gap_in_flight(const State<double>& start, double t) const {
  const State<double> ball = fly(start, scene_.gravity, t);
  const Floor floor = floor_at(t);
  if (switched_) return {gap(floor, ball), ball.velocity, -scene_.gravity, scene_.gravity, 0};
  const double most = scene_.amplitude * w_ * w_;  // of the floor's acceleration
  return {gap(floor, ball), ball.velocity - floor.speed, -scene_.gravity - floor.acceleration,
          scene_.gravity + most, most * w_};
}

// push = k (r - y + h) - c (v - h'), with y'' = -g; without the h' where the damper is absolute.
inline Glimpse OscillatingFloorExact::push_in_flight(const State<double>& start, double t) const {
  const double k = scene_.stiffness, c = scene_.damping, g = scene_.gravity;
  const double c_floor = relative_ ? c : 0;
  const State<double> ball = fly(start, g, t);
  const Floor floor = floor_at(t);
  const double most = scene_.amplitude * w_ * w_, most_jerk = most * w_;
  return {push(floor, ball),
          k * (floor.speed - ball.velocity) + c * g + c_floor * floor.acceleration,
          k * (floor.acceleration + g) + c_floor * floor.jerk, k * (most + g) + c_floor * most_jerk,
          k * most_jerk + c_floor * most_jerk * w_};
}

inline PhaseEnd OscillatingFloorExact::end_of_flight(const State<double>& start) const {
  // Nothing is touched above the highest point of the swing: fall there by formula.
  const double highest = switched_ ? 0 : height_ + scene_.amplitude;
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
  if (!clamped_ || relative_) return {touch.t, Phase::touch};
  // A damper that does not know the floor's speed may have to pull from the first moment on.
  const double first_push = push(floor_at(touch.t), fly(start, scene_.gravity, touch.t));
  return {touch.t, first_push > 0 ? Phase::touch : Phase::let_go};
}

// ---- Contact ------------------------------------------------------------------------------------

/// The ball's acceleration in contact, a = -g + push / m, is itself a solution of the shaken
/// oscillator: a steady swing with the floor, and a free one f that the damper lets die. The size
/// of a free swing, sqrt(f^2 + (f'/omega0)^2), is like the energy of a spring and never grows, so
/// that both together bound a for ever. Near resonance both are huge and cancel; there a better
/// bound is that the size of a itself grows by no more than the shaking adds, for some time to
/// come. An over-damped contact has no resonance, but two very different rates (free_bounds).
struct OscillatingFloorExact::Touch {
  Floor floor;
  State<double> ball;
  double acceleration, jerk;  // m/s^2, m/s^3
  double max[4];              // bounds of a and its first three derivatives for `window` seconds
  double window;              // s
};

/// The part of the movement that does not follow the floor: distance [m] and velocity [m/s].
inline State<double> OscillatingFloorExact::free_part(const State<double>& ball, double t,
                                                      Complex turned) const {
  const Complex steady = steady_ * turned;
  const double u = scene_.floor_velocity;
  return {ball.position - rest_height() - u * t - steady.imag(),
          ball.velocity - u - w_ * steady.real()};
}

/// Bounds of its acceleration from now on, and of the first three derivatives of that. An
/// over-damped swing is a sum of two exponentials, x = p e^(-slow t) + q e^(-fast t), and their
/// rates can be millions apart: once the fast one has died, nothing bends fast any more. Its share
/// now is what it was `before`, `since` seconds ago, less its decay; from the swing as it is now it
/// could not be told, because the rounding of a height, times fast^2, is no small acceleration.
inline std::array<double, 4> OscillatingFloorExact::free_bounds(const State<double>& free,
                                                                const State<double>& before,
                                                                double since) const {
  const double size = free_acceleration(free), bend = omega0_ * (2 * beta_ + omega0_);
  std::array<double, 4> bounds{size, omega0_ * size, bend * size,
                               (2 * beta_ * bend + omega0_ * omega0_ * omega0_) * size};
  if (beta_ <= omega0_) return bounds;
  const double root = std::sqrt((beta_ - omega0_) * (beta_ + omega0_));
  const double fast = beta_ + root, slow = omega0_ * omega0_ / fast;
  const double x = before.position, v = before.velocity;
  double p = std::abs(v + fast * x) / (2 * root) * slow * slow * std::exp(-slow * since);
  double q = std::abs(v + slow * x) / (2 * root) * fast * fast * std::exp(-fast * since);
  for (double& bound : bounds) {
    bound = std::min(bound, p + q);
    p *= slow;
    q *= fast;
  }
  return bounds;
}

/// The size of its acceleration f = -2 beta v - omega0^2 x [m/s^2].
inline double OscillatingFloorExact::free_acceleration(const State<double>& free) const {
  const double f = -2 * beta_ * free.velocity - omega0_ * omega0_ * free.position;
  const double f_rate = -2 * beta_ * f - omega0_ * omega0_ * free.velocity;
  return std::sqrt(f * f + f_rate * f_rate / (omega0_ * omega0_));
}

inline OscillatingFloorExact::Touch OscillatingFloorExact::touch_at(const State<double>& start,
                                                                    double t) const {
  const Complex turned = turn(t);
  return touch_at(t, ball_in_touch(start, t, turned), turned, 1 / omega0_, free_part(start, 0, 1),
                  t);
}

/// With the ball as it is at `t`, and bounds for at least `window` seconds.
inline OscillatingFloorExact::Touch OscillatingFloorExact::touch_at(
    double t, const State<double>& ball, Complex turned, double window,
    const State<double>& free_before, double since) const {
  Touch now;
  now.floor = floor_at(t, turned);
  now.ball = ball;
  now.acceleration = acceleration_in_touch(now.floor, ball);
  now.jerk = jerk_in_touch(now.floor, ball, now.acceleration);
  // a'' = shaking - 2 beta a' - omega0^2 a gives the bounds of the higher derivatives.
  const double fast = omega0_ * (2 * beta_ + omega0_);
  const double faster = 2 * beta_ * fast + omega0_ * omega0_ * omega0_;
  const double shaking = w_ * w_ * shaking_size_;
  const double a = now.acceleration, b = now.jerk / omega0_;
  const double grown = std::sqrt(a * a + b * b) + shaking * window / omega0_;

  const double steady = w_ * w_ * steady_size_;
  const std::array<double, 4> free = free_bounds(free_part(ball, t, turned), free_before, since);
  if (beta_ > omega0_ || steady + free[0] < grown) {
    now.window = never;
    now.max[0] = steady + free[0];
    now.max[1] = w_ * steady + free[1];
    now.max[2] = w_ * w_ * steady + free[2];
    now.max[3] = w_ * w_ * w_ * steady + free[3];
  } else {
    now.window = window;
    now.max[0] = grown;
    now.max[1] = omega0_ * grown;
    now.max[2] = shaking + fast * grown;
    now.max[3] = (w_ + 2 * beta_) * shaking + faster * grown;
  }
  return now;
}

inline Glimpse OscillatingFloorExact::overlap_in_touch(const State<double>& start, double t) const {
  const Touch now = touch_at(start, t);
  const Floor still{};
  const Floor& floor = switched_ ? still : now.floor;
  const double most = switched_ ? 0 : scene_.amplitude * w_ * w_;
  return {-gap(now.floor, now.ball),
          floor.speed - now.ball.velocity,
          floor.acceleration - now.acceleration,
          now.max[0] + most,
          now.max[1] + w_ * most,
          now.window};
}

inline Glimpse OscillatingFloorExact::push_in_touch(const State<double>& start, double t) const {
  const double k = scene_.stiffness, c = scene_.damping, m = scene_.mass;
  const Touch now = touch_at(start, t);
  const double bend = k * (now.floor.acceleration - now.acceleration) -
                      c * (now.jerk - (relative_ ? now.floor.jerk : 0));
  return {m * (now.acceleration + scene_.gravity),
          m * now.jerk,
          bend,
          m * now.max[2],
          m * now.max[3],
          now.window};
}

inline Lasting OscillatingFloorExact::touch_lasts(Phase next, double t,
                                                  const State<double>& state) const {
  const Floor floor = floor_at(t);
  if (next == Phase::flight) {
    return {-gap(floor, state), (switched_ ? 0 : floor.speed) - state.velocity};
  }
  const double a = acceleration_in_touch(floor, state);
  return {push(floor, state), scene_.mass * jerk_in_touch(floor, state, a)};
}

inline double OscillatingFloorExact::max_bend(Phase next, double t, const State<double>& state,
                                              double window) const {
  const Complex turned = turn(t);
  const Touch now = touch_at(t, state, turned, window, free_part(state, t, turned), 0);
  if (next == Phase::let_go) return scene_.mass * now.max[2];
  return now.max[0] + (switched_ ? 0 : scene_.amplitude * w_ * w_);
}

/// Does the ball stay in contact for ever? When steady and free swing together cannot open the
/// contact, it never opens. Under a very small weight the free swing is soon lost in the rounding
/// of the heights: what is smaller than that does not count.
inline bool OscillatingFloorExact::stays(const State<double>& start) const {
  const double u = scene_.floor_velocity;
  State<double> free = free_part(start, 0, 1);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                          (std::abs(start.position) + std::abs(rest_height()) + steady_size_);
  if (std::hypot(free.position, free.velocity / omega0_) < rounding) free = {0, 0};
  const double free_swing = std::hypot(free.position, free.velocity / omega0_);
  const double free_a = free_acceleration(free);

  // How far the spring is pressed in on average, and how much that swings. Both are written without
  // a difference of heights, in which a small weight would be lost.
  const double c_unknown = relative_ ? 0 : scene_.damping;  // what acts on the floor's speed, too
  double pressed = sag_ + c_unknown * u / scene_.stiffness;
  Complex swing = swing_ * answer_ * Complex(w_ * w_, -w_ * c_unknown / scene_.mass);
  if (switched_) {
    if (u > 0) return false;  // the ball rides up, and out of the switch
    pressed -= height_;
    swing = steady_;
  }
  const bool overlaps = std::abs(swing) + free_swing < pressed;
  const bool pushes = w_ * w_ * steady_size_ + free_a < scene_.gravity;
  return overlaps && (pushes || !clamped_);
}

inline PhaseEnd OscillatingFloorExact::end_of_contact(Phase phase,
                                                      const State<double>& start) const {
  const bool touching = phase == Phase::touch;
  if (touching && stays(start)) return {never, Phase::flight};

  const Phase other = touching ? Phase::let_go : Phase::touch;
  FirstZero opens{never, false}, changes{never, false};
  // A contact that only pushes and knows the floor's speed lets go before it opens.
  if (!(touching && clamped_ && relative_)) {
    const auto overlap = [&](double t) {
      if (touching) return overlap_in_touch(start, t);
      const Glimpse gap = gap_in_flight(start, t);
      return Glimpse{-gap.value, -gap.slope, -gap.bend, gap.max_bend, gap.max_turn, gap.window};
    };
    opens = first_zero(overlap, 0, never, patience);
  }
  if (clamped_) {
    const auto change = [&](double t) {
      if (touching) return push_in_touch(start, t);
      const Glimpse push = push_in_flight(start, t);
      return Glimpse{-push.value,   -push.slope,   -push.bend,
                     push.max_bend, push.max_turn, push.window};
    };
    changes = first_zero(change, 0, opens.t, patience);
  }
  if (opens.t <= changes.t) return {opens.t, opens.found ? Phase::flight : phase};
  return {changes.t, changes.found ? other : phase};
}

inline PhaseEnd OscillatingFloorExact::end_of(Phase phase, const State<double>& start) const {
  return phase == Phase::flight ? end_of_flight(start) : end_of_contact(phase, start);
}

}  // namespace bounce
