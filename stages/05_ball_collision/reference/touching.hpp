#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "05_ball_collision/ball_collision.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

/// Two balls that touch or could touch, or a ball and a surface; and what they are to each other.
struct ContactPair {
  int first, second;  // the second is -1 for a surface,
  int axis = 0;       // which pushes along sign * axis
  int sign = 0;
  Phase phase = Phase::flight;

  bool is_surface() const { return second < 0; }
  friend bool operator<(const ContactPair& a, const ContactPair& b) {
    return std::tie(a.first, a.second, a.axis, a.sign) <
           std::tie(b.first, b.second, b.axis, b.sign);
  }
};

/// The distance between their surfaces and how it changes.
struct Gap {
  double gap;                 // m, negative where they overlap
  double speed;               // m/s, at which it grows
  double distance;            // m, between the centres
  Eigen::Vector3d direction;  // unit vector towards the first ball
  Eigen::Vector3d velocity;   // m/s, of the first ball as the second sees it
};

inline double wall_of(const BallCollision& scene, const ContactPair& two) {
  return two.sign > 0 ? 0 : scene.tray[two.axis == 0 ? 0 : 1];
}

inline Gap gap_of(const BallCollision& scene, const ContactPair& two,
                  const State<Eigen::Matrix3Xd>& balls) {
  const int i = two.first, j = two.second;
  if (two.is_surface()) {
    const double height = two.sign * (balls.position(two.axis, i) - wall_of(scene, two));
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    direction[two.axis] = two.sign;
    return {height - scene.radius[i], two.sign * balls.velocity(two.axis, i), never, direction,
            balls.velocity.col(i)};
  }
  const Eigen::Vector3d between = balls.position.col(i) - balls.position.col(j);
  const Eigen::Vector3d velocity = balls.velocity.col(i) - balls.velocity.col(j);
  const double d = between.norm();
  Eigen::Vector3d e12 = Eigen::Vector3d::UnitY();  // where the centres coincide, as in meet()
  if (d > 1e-100) e12 = between * (1 / d);
  return {d - scene.radius[i] - scene.radius[j], dot(velocity, e12), d, e12, velocity};
}

/// Whether that gap is larger than `range` [m], which may be negative: the same without root and
/// division.
inline bool are_apart(const BallCollision& scene, const ContactPair& two,
                      const Eigen::Matrix3Xd& position, double range) {
  const int i = two.first, j = two.second;
  if (two.is_surface()) {
    return two.sign * (position(two.axis, i) - wall_of(scene, two)) > scene.radius[i] + range;
  }
  const double reach = scene.radius[i] + scene.radius[j] + range;
  return reach < 0 || (position.col(i) - position.col(j)).squaredNorm() > reach * reach;
}

/// By how much that gap may be off [m], because positions are rounded.
inline double rounding_of_gap(const BallCollision& scene, const ContactPair& two,
                              const State<Eigen::Matrix3Xd>& balls) {
  const auto size = [&](int i) {
    return balls.position.col(i).cwiseAbs().maxCoeff() + scene.radius[i];
  };
  const double other = two.is_surface() ? std::abs(wall_of(scene, two)) : size(two.second);
  return 8 * std::numeric_limits<double>::epsilon() * (size(two.first) + other);
}

/// All balls in free flight for `t` seconds.
inline State<Eigen::Matrix3Xd> fly(const State<Eigen::Matrix3Xd>& balls, double gravity, double t) {
  State<Eigen::Matrix3Xd> later{balls.position + balls.velocity * t, balls.velocity};
  later.position.row(1).array() -= gravity * t * t / 2;
  later.velocity.row(1).array() -= gravity * t;
  return later;
}

// [time_to_touch]
/// When two touch that fly [s]: `never` if they miss. Both balls of a pair fall alike, so that each
/// sees the other on a straight line: |p + u t| = R, a quadratic equation. With p = d e12 it is
/// u^2 t^2 + 2 d (u e12) t + (d - R)(d + R) = 0, and the first root is written so that nothing is
/// subtracted. The discriminant is u^2 R^2 - |p x u|^2.
inline double time_to_touch(const BallCollision& scene, const ContactPair& two,
                            const State<Eigen::Matrix3Xd>& balls) {
  const Gap now = gap_of(scene, two, balls);
  const double apart = std::max(0.0, now.gap);
  if (two.is_surface()) {
    return time_to_fall(apart, now.speed, two.axis == 1 ? scene.gravity : 0);
  }
  if (!(now.speed < 0)) return never;
  const double reach = scene.radius[two.first] + scene.radius[two.second];
  const double speed = now.velocity.norm();
  const double aside = now.distance * now.direction.cross(now.velocity).norm();
  const double square = (speed * reach - aside) * (speed * reach + aside);
  if (square < 0) return never;
  return apart * (now.distance + reach) / (std::sqrt(square) - now.distance * now.speed);
}
// [time_to_touch]

}  // namespace bounce
