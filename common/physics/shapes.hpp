#pragma once
#include <Eigen/Core>

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
  double distance(const Eigen::Vector3d& point) const { return normal.dot(point) + offset; }

  /// The nearest point of the plane.
  Eigen::Vector3d foot(const Eigen::Vector3d& point) const {
    return point - distance(point) * normal;
  }
};

}  // namespace bounce
