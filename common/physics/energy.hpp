#pragma once
#include <algorithm>

namespace bounce {

/// A ball's energy [J] by where it is kept.
struct Energy {
  double kinetic = 0;
  double gravitational = 0;
  double spring = 0;

  double total() const { return kinetic + gravitational + spring; }
};

/// m v^2 / 2, in one dimension.
inline double kinetic_energy(double mass, double velocity) {
  return mass * velocity * velocity / 2;
}

/// m |v|^2 / 2, for a velocity that is an Eigen vector.
template <class Vector>
requires requires(const Vector& velocity) { velocity.squaredNorm(); }
double kinetic_energy(double mass, const Vector& velocity) {
  return mass * velocity.squaredNorm() / 2;
}

/// m g y: zero at height 0, and negative below.
inline double gravitational_energy(double mass, double gravity, double height) {
  return mass * gravity * height;
}

/// k d^2 / 2 for an overlap d > 0; without overlap the spring is at rest.
inline double spring_energy(double stiffness, double overlap) {
  const double compression = std::max(0.0, overlap);
  return stiffness * compression * compression / 2;
}

}  // namespace bounce
