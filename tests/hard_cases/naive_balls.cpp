// Balls among each other, the naive way.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "naive.hpp"
#include "naive_heap.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "physics/neighbour_grid.hpp"

namespace bounce::naive {
namespace {

using Eigen::Vector3d;

std::string coincident_centres() {
  std::array<State<Vector3d>, 2> balls;
  for (auto& [position, velocity] : balls) position.setZero(), velocity.setZero();
  const Vector3d between = balls[0].position - balls[1].position, e12 = between / between.norm();
  for (const double sign : {1.0, -1.0}) {
    auto& ball = balls[sign > 0 ? 0 : 1];
    ball.velocity += sign * 1e4 * (0.2 - between.norm()) * e12 * 1e-3;
    ball.position += ball.velocity * 1e-3;
  }
  const auto none = [](const Vector3d& v) { return (v.array() != v.array()).count(); };
  return "0 / 0: after one step " +
         std::to_string(none(balls[0].position) + none(balls[1].position)) +
         " of 6 coordinates are NaN";
}

std::string nearly_coincident() {
  int exponent = -100;
  for (double x = 1e-100; std::sqrt(x * x) > 0; x = std::pow(10, exponent)) --exponent;
  return "from 1e" + std::to_string(exponent) +
         " m on `sqrt(x * x + y * y + z * z)` is 0, and the direction no number";
}

std::string step_of_the_heavy_one() {
  BallCollision scene;
  scene.gravity = 0;
  scene.floor = false;
  scene.mass.resize(2);
  scene.mass << 1, 1e-6;
  scene.radius = Eigen::VectorXd::Constant(2, 0.1);
  State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 2)};
  balls.position(0, 0) = -0.21;
  balls.velocity(0, 0) = 1;
  for (int i = 0; i < 100; ++i) semi_implicit_euler(scene, 0, balls, 1e-3);  // omega0 dt = 0.1
  return "with the step that suits the heavy one, the light one leaves at " +
         digits(balls.velocity.col(1).norm(), 2) + " m/s, and should at 2";
}

/// Equal balls in a row that touch: each pair that comes together trades its speeds, in that order.
template <std::size_t count>
std::array<double, 3> pair_by_pair(std::array<double, 3> v, const int (&order)[count]) {
  for (const int i : order) {
    double& left = v[static_cast<std::size_t>(i)];
    double& right = v[static_cast<std::size_t>(i) + 1];
    if (left > right) std::swap(left, right);
  }
  return v;
}

std::string three_balls() {
  const double onwards = pair_by_pair({1, 0, 0}, {0, 1})[2];
  const double back = pair_by_pair({1, 0, 0}, {1, 0})[2];
  return "pair by pair, the last of three leaves at " + digits(onwards) + " or at " + digits(back) +
         " m/s, as the pairs are ordered";
}

std::string two_touches() {
  const auto [left, middle, right] = pair_by_pair({2, 0, -2}, {0, 1});
  return "the first one handled wins: from 2, 0, -2 m/s come " + digits(left) + ", " +
         digits(middle) + ", " + digits(right);
}

std::string another_order() {
  Heap heap, reversed;
  reversed.reverse();
  const auto step = [](Heap& one) { semi_implicit_euler(one.scene, 0, one.balls, one.dt); };
  for (int i = 0; i < heap.steps; ++i) step(heap), step(reversed);
  reversed.reverse();
  return "sums round differently: " + std::to_string(heap.count) +
         " balls without dampers are up to " + digits(heap.distance_to(reversed), 1) +
         " m elsewhere after 3 s";
}

std::string another_search() {
  const Heap heap = Heap::at_rest();
  const int changed = heap.changed_sums([](const std::vector<Vector3d>& pushes) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = pushes.size(); i-- > 0;) sum += pushes[i];
    return sum;
  });
  return "the pairs found in another order change the last bits of the force on " +
         std::to_string(changed) + " of " + std::to_string(heap.count) + " balls";
}

constexpr double many = 1e5, few = 2000;

std::vector<BallPair> pairs_of_few(double spacing) {
  std::vector<BallPair> pairs;
  for (int i = 0; i < few; ++i) {
    for (int j = i + 1; j < few; ++j) {
      if ((j - i) * spacing < 0.2) pairs.push_back({i, j});
    }
  }
  return pairs;
}

std::string pairs_in_one_place() {
  const auto pairs = static_cast<double>(pairs_of_few(0).size());
  const double megabytes = pairs * sizeof(BallPair) / 1e6;
  return "2000 of them have a list of " + digits(pairs) + " pairs and " + digits(megabytes, 2) +
         " MB; 1e5 have " + digits(megabytes / 1000 * (many / few) * (many / few), 2) + " GB";
}

std::string pairs_that_come() {
  const auto at = [](double spacing) {
    return digits(static_cast<double>(pairs_of_few(spacing).size()));
  };
  return "checked at the start only: of 2000 such balls " + at(0.25) +
         " pairs touch at the start, " + at(0.25 / 10) + " after 9 ms, " + at(0) + " after 10 ms";
}

}  // namespace

void print_balls() {
  print_cases({{"Coincident centres", coincident_centres},
               {"Nearly coincident, from 1e-3 m to a denormal distance", nearly_coincident},
               {"Mass ratio 1e6", step_of_the_heavy_one},
               {"Three balls at once", three_balls},
               {"Two touches at the same instant", two_touches},
               {"Balls in another order", another_order},
               {"The same order, another search", another_search},
               {"1e5 balls in one place", pairs_in_one_place},
               {"1e5 balls fly into one place in the middle of a run", pairs_that_come}});
}

}  // namespace bounce::naive
