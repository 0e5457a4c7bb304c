#pragma once

namespace bounce {

/// Where the ball is [m] and how fast it moves [m/s]. This is all that a ball without spin can
/// remember: the force follows from it, and everything later follows from the force.
/// `Vector` is `double` in one dimension and `Eigen::Vector3d` in three.
template <class Vector>
struct State {
  Vector position;
  Vector velocity;
};

}  // namespace bounce
