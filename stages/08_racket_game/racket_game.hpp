#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "physics/components.hpp"
#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/shapes.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Where a ball is nearest to the racket.
struct NearestPoint {
  Eigen::Vector3d point;      // on the racket
  Eigen::Vector3d direction;  // from there to the ball, of length 1
  double distance;            // m; negative when the ball's centre is through the disc
};

/// Stage 8. The plane of stage 7 ends at a rim, has two sides, and moves. Like every floor before
/// it is frictionless: it pushes along the line from its nearest point to the ball, and nowhere
/// else.
struct Racket {
  double mass = 1.0;       // kg
  double gravity = 9.81;   // m/s^2
  double radius = 0.1;     // m, of the ball
  double stiffness = 1e4;  // N/m
  double damping = 14.17;  // N s/m: restitution 0.8
  ContactLaw contact = ContactLaw::may_pull;
  Disc disc;             // where the racket is at `since`, and how it moves from there
  double since = 0;      // s
  int side = 1;          // where the ball comes from: 1 is the side of the normal, -1 the other
  bool through = false;  // pressed through the disc, with its centre, and not let off since

  /// The racket at time `t`.
  Disc disc_at(double t) const { return disc.after(t - since); }

  // [nearest]
  NearestPoint nearest(const Disc& racket, const Eigen::Vector3d& ball) const {
    const Eigen::Vector3d outwards = racket.outwards(ball);  // along the racket, from its centre
    const double lateral = outwards.norm();
    if (lateral < racket.radius) {  // over the disc: the plane of stage 7
      return {racket.centre + outwards, side * racket.normal, side * racket.height(ball)};
    }
    // Beside it: the nearest point is on the rim, and the push goes from there to the ball.
    const Eigen::Vector3d rim = racket.centre + outwards * (racket.radius / lateral);
    const double distance = (ball - rim).norm();
    if (distance == 0) return {rim, side * racket.normal, 0};
    if (through && side * racket.height(ball) < 0) return beyond_rim(racket, rim, ball);
    return {rim, (ball - rim) / distance, distance};
  }
  // [nearest]

  // [force]
  Eigen::Vector3d force(double t, const State<Eigen::Vector3d>& state) const {
    // Distance of the centre from the racket, and velocity away from the point that is touched.
    const Disc racket = disc_at(t);
    const auto [point, n, y] = nearest(racket, state.position);
    const double v = dot(n, state.velocity - racket.velocity_of(point));
    // Gravity, downwards.
    Eigen::Vector3d force(0, -mass * gravity, 0);
    // Only while the ball overlaps the racket: a spring, and a damper against the velocity.
    if (y < radius) {
      double push = stiffness * (radius - y) - damping * v;
      if (contact == ContactLaw::push_only) push = std::max(0.0, push);
      force += push * n;  // along the normal
    }
    return force;
  }
  // [force]

  Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
    return force(t, state) / mass;
  }

  // [side]
  /// Which side the ball is on. While the two touch this does not change, however deep a fast ball
  /// gets in: a ball from below is pushed down, even with its centre above the disc already.
  void choose_side(double t, const Eigen::Vector3d& ball) {
    const Disc racket = disc_at(t);
    const bool over_disc = racket.outwards(ball).norm() < racket.radius;
    const double height = racket.height(ball);
    if (over_disc && side * height < radius) {
      through = side * height < 0;
      return;
    }
    // Pressed through the disc, out over its rim, and still pushed.
    if (through && side * height < 0 && nearest(racket, ball).distance < radius) return;
    through = false;
    side = height < 0 ? -1 : 1;
  }
  // [side]

  /// For a ball that was put where it is.
  void start_side(double t, const Eigen::Vector3d& ball) {
    side = disc_at(t).height(ball) < 0 ? -1 : 1;
    through = false;
  }

  /// Only the course's own nearest() asks for this: it is not part of the exercise.
  /// A ball whose centre was pressed through the disc, and that slides out over the rim: x > 0
  /// outwards from the rim, y < 0 up from the disc. Its nearest point is on the rim, but that is on
  /// its other side: the push would turn round at once, from up to down. This one turns evenly,
  /// from up (x = 0, as over the disc) to outwards (y = 0, as beside it): with x = l cos a and
  /// y = l sin a the distance l cos 2a, for which -l and l and their slopes agree with the two. The
  /// direction is its gradient, so that no energy is gained or lost; its length is up to 2.
  NearestPoint beyond_rim(const Disc& racket, const Eigen::Vector3d& rim,
                          const Eigen::Vector3d& ball) const {
    const Eigen::Vector3d up = side * racket.normal;
    const Eigen::Vector3d out = (rim - racket.centre) / racket.radius;
    const double length = (ball - rim).norm();
    const double x = dot(out, ball - rim) / length, y = dot(up, ball - rim) / length;
    return {rim, x * (1 + 2 * y * y) * out - y * (1 + 2 * x * x) * up, length * (x * x - y * y)};
  }

  double overlap(double t, const State<Eigen::Vector3d>& state) const {
    return std::max(0.0, radius - nearest(disc_at(t), state.position).distance);
  }

  /// What the damper gives to the ball [W], seen from the racket: all that is neither gravity nor
  /// spring. In a push-only contact that has let go it takes away what the spring still gives.
  double damper_power(double t, const State<Eigen::Vector3d>& state) const {
    const double pressed = overlap(t, state);
    if (pressed == 0) return 0;
    const Disc racket = disc_at(t);
    const NearestPoint at = nearest(racket, state.position);
    const Eigen::Vector3d v = state.velocity - racket.velocity_of(at.point);
    const Eigen::Vector3d push = force(t, state) + Eigen::Vector3d(0, mass * gravity, 0);
    return dot(push, v) - stiffness * pressed * dot(at.direction, v);
  }

  Energy energy(double t, const State<Eigen::Vector3d>& state) const {
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position.y()),
            spring_energy(stiffness, overlap(t, state))};
  }

  std::vector<Parameter> parameters() {
    Parameter place = describe::position(components(disc.centre), 2);
    place.name = "racket_position";
    place.meaning = "the disc's centre x,y,z at the start; in the game its home";
    Parameter size = describe::radius(disc.radius);
    size.name = "racket_radius";
    size.meaning = "of the disc; in the game it shrinks to half";
    return {describe::mass(mass),
            describe::gravity(gravity),
            describe::radius(radius),
            describe::stiffness(stiffness),
            describe::damping(damping),
            describe::contact(contact),
            place,
            size};
  }
};

}  // namespace bounce
