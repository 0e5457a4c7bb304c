#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>

namespace bounce {

// One dimension or three: a position is a `double` or an Eigen vector. Traces, files and parameters
// want plain numbers. These few functions see both kinds of position as a row of numbers, so that
// what is written once serves all stages, and stages 1 to 3 need no Eigen.

/// What a position can be: a number, an Eigen vector, or a matrix with a column for each ball.
template <class Any>
concept VectorOrNumber = std::is_same_v < std::remove_const_t<Any>,
double > || requires(const Any& any) { any.data(), any.cols(); };

/// The numbers that `vector` is made of; through them it can be read and changed.
template <VectorOrNumber Vector>
auto components(Vector& vector) {
  using Number = std::conditional_t<std::is_const_v<Vector>, const double, double>;
  if constexpr (std::is_same_v<std::remove_const_t<Vector>, double>) {
    return std::span<Number>(&vector, 1);
  } else {
    return std::span<Number>(vector.data(), static_cast<std::size_t>(vector.size()));
  }
}

/// Dot product; in one dimension the product. The order of the sum is written out: Eigen 5 adds
/// three products in another one than Eigen 3.4, and a run's last bits would depend on that.
template <class A, class B>
double dot(const A& a, const B& b) {
  if constexpr (std::is_same_v<A, double>) {
    return a * b;
  } else {
    static_assert(A::SizeAtCompileTime == 3 && B::SizeAtCompileTime == 3);
    return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
  }
}

/// Distance between two positions [m], or size of the difference of two velocities [m/s]. Of many
/// balls, a column for each: of the one that is furthest off.
template <class Vector>
double largest_distance(const Vector& a, const Vector& b) {
  if constexpr (std::is_same_v<Vector, double>) {
    return std::abs(a - b);
  } else if constexpr (Vector::ColsAtCompileTime == 1) {
    return (a - b).norm();
  } else {
    return (a - b).colwise().norm().maxCoeff();
  }
}

/// No component is infinite or "not a number".
template <class Vector>
bool is_finite(const Vector& vector) {
  for (const double number : components(vector)) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

}  // namespace bounce
