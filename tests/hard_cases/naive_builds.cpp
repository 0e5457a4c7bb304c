// What compilers and machines may do, the naive way.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "naive.hpp"
#include "naive_heap.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::naive {
namespace {

/// The slides' step as a compiler makes it that may contract a * b + c to one rounding.
void contracted_step(Heap& heap, double dt) {
  const Eigen::Matrix3Xd& acceleration = heap.scene.acceleration(0, heap.balls);
  for (Eigen::Index i = 0; i < 3 * heap.count; ++i) {
    double& v = heap.balls.velocity.data()[i];
    double& x = heap.balls.position.data()[i];
    v = std::fma(acceleration.data()[i], dt, v);
    x = std::fma(v, dt, x);
  }
}

std::string contraction() {
  Heap heap, contracted;
  for (int i = 0; i < heap.steps; ++i) {
    semi_implicit_euler(heap.scene, 0, heap.balls, heap.dt);
    contracted_step(contracted, heap.dt);
  }
  return "with fused multiply-adds " + std::to_string(heap.count) + " balls are up to " +
         digits(heap.distance_to(contracted), 1) + " m elsewhere after 3 s";
}

std::string lanes() {
  const Heap heap = Heap::at_rest();
  const int changed = heap.changed_sums([](const std::vector<Eigen::Vector3d>& pushes) {
    Eigen::Vector3d lane[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (std::size_t i = 0; i < pushes.size(); ++i) lane[i % 2] += pushes[i];
    return Eigen::Vector3d(lane[0] + lane[1]);
  });
  return "pushes summed in two lanes or by two threads change the last bits of the force on " +
         std::to_string(changed) + " of " + std::to_string(heap.count) + " balls";
}

std::string silent_nan() {
  Heap heap;
  heap.balls.velocity(1, 0) = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 1000; ++i) semi_implicit_euler(heap.scene, 0, heap.balls, heap.dt);
  double highest = 0;
  int lost = 0;
  for (const double y : heap.balls.position.row(1)) {
    highest = std::max(highest, y);
    lost += std::isnan(y) ? 1 : 0;
  }
  return "no comparison sees it: of " + std::to_string(heap.count) + " heights " +
         std::to_string(lost) + " is NaN, and their `std::max` is " + digits(highest, 2) + " m";
}

}  // namespace

void print_builds() {
  print_cases({{"The same run from another compiler, or with other optimisation", contraction},
               {"Vector units and threads: stage 5's fast path", lanes},
               {"A NaN on the way", silent_nan}});
}

}  // namespace bounce::naive
