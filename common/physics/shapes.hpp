#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/components.hpp"

namespace bounce {

/// The infinite plane of all points p with normal . p + offset = 0. The normal has unit length:
/// only then is the left side a distance in metres.
struct Plane {
  Eigen::Vector3d normal{0, 1, 0};  // points to the side where the ball is
  double offset = 0;                // m

  /// From a x + b y + c z + d = 0 with a normal (a, b, c) of any length but zero. Both sides of the
  /// equation are divided by that length, so that it still tells the same points.
  // [from_equation]
  static Plane from_equation(const Eigen::Vector3d& normal, double d) {
    const double largest = normal.cwiseAbs().maxCoeff();  // first by this: squares stay in range
    const Eigen::Vector3d scaled = normal / largest;
    const double length = scaled.norm();
    return {scaled / length, d / largest / length};
  }
  // [from_equation]

  /// How far `point` is from the plane [m]; negative behind it.
  double distance(const Eigen::Vector3d& point) const { return dot(normal, point) + offset; }

  /// The nearest point of the plane.
  Eigen::Vector3d foot(const Eigen::Vector3d& point) const {
    return point - distance(point) * normal;
  }
};

/// A rigid disc without thickness that moves and turns.
struct Disc {
  Eigen::Vector3d centre{0, 0, 0};            // m
  Eigen::Vector3d normal{0, 1, 0};            // unit length
  double radius = 0.3;                        // m
  Eigen::Vector3d velocity{0, 0, 0};          // of the centre [m/s]
  Eigen::Vector3d angular_velocity{0, 0, 0};  // rad/s, about the centre

  /// How far `point` is above the disc's plane [m]; negative behind it.
  double height(const Eigen::Vector3d& point) const { return dot(normal, point - centre); }

  /// The nearest point of the disc's plane, seen from the centre.
  Eigen::Vector3d outwards(const Eigen::Vector3d& point) const {
    return point - centre - height(point) * normal;
  }

  /// The velocity of that point of the disc, or of a point that moves with it [m/s].
  Eigen::Vector3d velocity_of(const Eigen::Vector3d& point) const {
    return velocity + angular_velocity.cross(point - centre);
  }

  /// The disc `t` seconds later, when it goes on moving and turning as it does now.
  Disc after(double t) const {
    Disc later = *this;
    later.centre += velocity * t;
    const double speed = angular_velocity.norm();
    if (speed > 0) later.normal = Eigen::AngleAxisd(speed * t, angular_velocity / speed) * normal;
    return later;
  }
};

}  // namespace bounce
