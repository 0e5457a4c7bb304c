#pragma once
#include <algorithm>
#include <cmath>

#include "08_racket_game/racket_game.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/first_zero.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Stage 8 in closed form, seen from a racket in uniform motion that does not turn: positions and
/// velocities count from its centre. From there the racket rests, and it is stage 7 - as long as
/// the ball touches the disc inside its rim, or passes beside it. At the rim the push turns with
/// the ball, and no formula solves that: it is the last event, and to move on from there throws
/// NoClosedForm.
class RacketExact {
 public:
  using Ball = State<Eigen::Vector3d>;

  explicit RacketExact(const Racket& scene)
      : normal_(scene.disc.normal),
        disc_radius_(scene.disc.radius),
        ball_radius_(scene.radius),
        gravity_(0, -scene.gravity, 0),
        front_(phases(scene, 1)),
        back_(phases(scene, -1)),
        side_(scene.side) {}

  Phase phase_at(const Ball& ball) {
    if (!is_over_disc(ball)) return Phase::flight;
    const Phase phase = on_side(side_).phase_at(upwards(side_, ball));
    if (phase == Phase::flight) side_ = side_of(ball);
    return phase;
  }

  void begin(double t) { phase_start_ = t; }

  Ball move(Phase phase, const Ball& start, double t) const {
    if (is_at_rim_) {
      throw NoClosedForm(phase_start_,
                         "the ball meets the racket's rim, for which there is no closed form,");
    }
    const Ball flown = fly(start, t);
    if (phase != Phase::touch) return flown;
    const State<double> height = on_side(side_).move(phase, upwards(side_, start), t);
    return at_height(flown, height);
  }

  PhaseEnd end_of(Phase phase, const Ball& start) {
    if (is_at_rim_) return {never, phase};
    if (phase == Phase::flight) return end_of_flight(start);
    const PhaseEnd end = on_side(side_).end_of(phase, upwards(side_, start));
    const FirstZero rim = time_to_rim(start, end.after);
    reaches_rim_ = rim.found && rim.t < end.after;
    if (reaches_rim_) return {rim.t, Phase::flight};
    return rim.t < end.after ? PhaseEnd{rim.t, phase} : end;
  }

  /// Nothing happens where a search for the rim took too many looks: it goes on from here.
  Ball at_event(Phase before, Phase after, const Ball& ball) {
    is_at_rim_ = reaches_rim_;
    if (is_at_rim_ || before == after) return ball;
    if (before == Phase::flight) side_ = side_of(ball);
    return at_height(ball, on_side(side_).at_event(before, after, upwards(side_, ball)));
  }

  bool is_at_rim() const { return is_at_rim_; }

 private:
  // ---- The two directions: along the normal it is stage 3, along the disc a parabola.

  Ball fly(const Ball& start, double t) const { return bounce::fly(start, gravity_, t); }

  int side_of(const Ball& ball) const { return dot(normal_, ball.position) < 0 ? -1 : 1; }

  /// Height above that side of the disc, and speed away from it.
  State<double> upwards(int side, const Ball& ball) const {
    return {side * dot(normal_, ball.position), side * dot(normal_, ball.velocity)};
  }
  const BouncePhases& on_side(int side) const { return side > 0 ? front_ : back_; }
  /// Gravity towards the disc, on that side of it [m/s^2].
  double pull(int side) const { return -side * dot(normal_, gravity_); }
  static BouncePhases phases(const Racket& scene, int side) {
    return {scene.mass,
            side * scene.disc.normal.y() * scene.gravity,
            scene.radius,
            {scene.stiffness, scene.damping, scene.contact}};
  }
  Ball at_height(const Ball& ball, const State<double>& height) const {
    const State<double> old = upwards(side_, ball);
    return {ball.position + (side_ * (height.position - old.position)) * normal_,
            ball.velocity + (side_ * (height.velocity - old.velocity)) * normal_};
  }
  Eigen::Vector3d along(const Eigen::Vector3d& vector) const {
    return vector - dot(normal_, vector) * normal_;
  }
  bool is_over_disc(const Ball& ball) const { return along(ball.position).norm() < disc_radius_; }

  // ---- Flight

  /// The ball comes down to the height of its radius on one side. Over the disc it touches there;
  /// beside it, it may meet the rim, or pass and come again.
  PhaseEnd end_of_flight(const Ball& start) {
    reaches_rim_ = false;
    Ball ball = start;
    double after = 0;
    constexpr int most_passes = 8;  // a parabola crosses a slab twice
    for (int pass = 0; pass < most_passes; ++pass) {
      const int side = side_of(ball);
      const State<double> height = upwards(side, ball);
      const bool is_beside = height.position < ball_radius_ * (1 - 1e-12) && !is_over_disc(ball);
      const double above = std::max(0.0, height.position - ball_radius_);
      const double down = is_beside ? 0 : time_to_fall(above, height.velocity, pull(side));
      if (down == never) break;
      ball = fly(ball, down);
      after += down;
      if (is_over_disc(ball)) return {after, Phase::touch};
      const double out = time_out_of_slab(side, ball);
      const FirstZero rim = time_to_touch_rim(ball, out);
      reaches_rim_ = rim.found && rim.t < out;
      if (reaches_rim_) return {after + rim.t, Phase::touch};
      if (rim.t < out) return {after + rim.t, Phase::flight};
      if (out == never) break;
      ball = fly(ball, out);
      after += out;
    }
    return {never, Phase::flight};
  }

  /// When a ball beside the disc, at most its radius from the disc's plane, is further away again.
  double time_out_of_slab(int side, const Ball& ball) const {
    const State<double> height = upwards(side, ball);
    const double g = pull(side);
    const double below = time_to_fall(height.position + ball_radius_, height.velocity, g);
    const double above =
        time_to_fall(std::max(0.0, ball_radius_ - height.position), -height.velocity, -g);
    return std::min(below, above > 0 ? above : never);
  }

  // ---- The rim: the first zero of a distance, found by steps that are certain to be free of one

  static constexpr int most_looks = 1000;  // some tens are needed, also by a ball that grazes it

  /// For a ball in contact: when it is no longer over the disc. By squares, which are smooth at the
  /// disc's centre as well: R^2 - p^2 bends by -2 (v^2 + p.a), and in the next `window` no ball
  /// over the disc can be faster than v + a window.
  FirstZero time_to_rim(const Ball& start, double end) const {
    const Ball foot{along(start.position), along(start.velocity)};
    const Eigen::Vector3d pull = along(gravity_);
    const double a = pull.norm();
    const auto value_at = [&](double t) {
      const Ball now = bounce::fly(foot, pull, t);
      const double v = now.velocity.norm();
      const double faster = std::max(v, std::sqrt(a * disc_radius_));
      const double fastest = v + (a > 0 ? faster : 0);
      return BoundedValue{
          (disc_radius_ - now.position.norm()) * (disc_radius_ + now.position.norm()),
          -2 * dot(now.position, now.velocity),
          -2 * (v * v + dot(now.position, pull)),
          2 * (fastest * fastest + a * disc_radius_),
          0,
          a > 0 ? faster / a : never};
    };
    return first_zero(value_at, 0, end, most_looks);
  }

  /// For a ball beside the disc: when it touches the rim. The disc is convex, so that the distance
  /// to it is a convex function of where the ball is: in flight it never bends by less than -g.
  FirstZero time_to_touch_rim(const Ball& start, double end) const {
    const auto value_at = [&](double t) {
      const Ball ball = fly(start, t);
      const Eigen::Vector3d outwards = along(ball.position);
      const double lateral = outwards.norm();
      const double beside = std::max(0.0, lateral - disc_radius_);
      const double height = dot(normal_, ball.position);
      const double distance = std::hypot(beside, height);
      const double leaving = beside > 0 ? beside * dot(outwards, ball.velocity) / lateral : 0;
      const double growth = leaving + height * dot(normal_, ball.velocity);  // of distance^2 / 2
      return BoundedValue{distance - ball_radius_, distance > 0 ? growth / distance : 0, 0,
                          gravity_.norm(), 0};
    };
    if (value_at(0).value < 0) return {0, true};  // a start in contact with it
    return first_zero(value_at, 0, end, most_looks);
  }

  Eigen::Vector3d normal_;
  double disc_radius_, ball_radius_;
  Eigen::Vector3d gravity_;
  BouncePhases front_, back_;
  int side_;                  // of the disc that the ball touches or touched last
  bool reaches_rim_ = false;  // at the end of this phase
  bool is_at_rim_ = false;
  double phase_start_ = 0;  // s
};

/// A ball as it is seen from a disc that does not turn, and back as it is seen from the ground.
inline State<Eigen::Vector3d> seen_from(const Disc& disc, const State<Eigen::Vector3d>& ball) {
  return {ball.position - disc.centre, ball.velocity - disc.velocity};
}
inline State<Eigen::Vector3d> from_ground(const Disc& disc, const State<Eigen::Vector3d>& seen) {
  return {seen.position + disc.centre, seen.velocity + disc.velocity};
}

}  // namespace bounce
