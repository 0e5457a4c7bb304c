#include "physics/neighbour_grid.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

#include "floating_point_traps.hpp"
#include "random_numbers.hpp"

using namespace bounce;

namespace {

/// The definition, word for word: for every i, for every j after it, are they close enough?
std::vector<BallPair> by_double_loop(const Eigen::Matrix3Xd& position,
                                     const Eigen::VectorXd& radius) {
  std::vector<BallPair> pairs;
  for (int i = 0; i < position.cols(); ++i) {
    for (int j = i + 1; j < position.cols(); ++j) {
      const double distance = (position.col(i) - position.col(j)).norm();
      if (radius[i] + radius[j] - distance > 0) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// The grid may give pairs that touch within rounding; they feel no force. What counts: it leaves
/// none out, it invents none, and it keeps the order.
void check_same(NeighbourGrid& grid, const Eigen::Matrix3Xd& position,
                const Eigen::VectorXd& radius) {
  std::vector<BallPair> touching;
  for (const BallPair& pair : grid.pairs(position, radius)) {
    const double distance = (position.col(pair.first) - position.col(pair.second)).norm();
    const double touch = radius[pair.first] + radius[pair.second];
    CHECK(distance <= touch * (1 + 1e-11));
    if (touch - distance > 0) touching.push_back(pair);
  }
  CHECK(touching == by_double_loop(position, radius));
}

struct Random {
  std::mt19937_64 generator;
  double operator()(double low, double high) { return test::uniform(generator, low, high); }
  Eigen::Matrix3Xd positions(int count, const Eigen::Vector3d& corner, double size) {
    Eigen::Matrix3Xd position(3, count);
    for (int i = 0; i < count; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        position(axis, i) = corner[axis] + (*this)(0, size);
      }
    }
    return position;
  }
};

}  // namespace

TEST_CASE("the grid finds the pairs of the double loop, in its order, in random states") {
  NeighbourGrid grid;  // one for all: it must not remember the state before
  for (const int seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    for (const int count : {0, 1, 2, 3, 40, 500}) {
      CAPTURE(seed);
      CAPTURE(count);
      Random random{std::mt19937_64(static_cast<unsigned>(seed))};
      const Eigen::VectorXd radius = Eigen::VectorXd::Constant(count, 0.1);
      check_same(grid, random.positions(count, {0, 0, 0}, 1.5), radius);       // dense
      check_same(grid, random.positions(count, {-3, -3, -3}, 6), radius);      // negative too
      check_same(grid, random.positions(count, {1e7, -1e7, 1e7}, 1), radius);  // far out
      check_same(grid, random.positions(count, {0, 0, 0}, 0.05), radius);      // all in one cube
      Eigen::Matrix3Xd flat = random.positions(count, {-2, 0, -2}, 4);
      flat.row(1).setConstant(0.1);
      check_same(grid, flat, radius);
      // Exactly on the borders of cubes and exactly touching.
      Eigen::Matrix3Xd lattice = random.positions(count, {-4, -4, -4}, 8);
      lattice = (lattice.array().round() * 0.2).matrix();
      check_same(grid, lattice, radius);
    }
  }
}

TEST_CASE("the grid finds all pairs with very different radii") {
  NeighbourGrid grid;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    CAPTURE(seed);
    Random random{std::mt19937_64(seed)};
    const Eigen::Matrix3Xd position = random.positions(300, {-1, -1, -1}, 2);
    Eigen::VectorXd radius(300);
    for (double& r : radius) r = std::pow(10, random(-4, -0.5));  // 0.1 mm to 0.3 m
    check_same(grid, position, radius);
    radius[17] = 50;  // one that holds all the others
    check_same(grid, position, radius);
    radius.setConstant(1e-30);
    check_same(grid, position, radius);
  }
}

TEST_CASE("the grid finds all pairs around balls that are lost, and among them") {
  NeighbourGrid grid;
  Random random{std::mt19937_64(9)};
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(200, 0.1);
  Eigen::Matrix3Xd position = random.positions(200, {0, 0, 0}, 1);
  for (const double far : {1e3, 1e7, 1e15, -1e15}) {
    CAPTURE(far);
    position.col(5) = Eigen::Vector3d(far, 0, 0);
    position.col(120) = Eigen::Vector3d(far, 0.15, 0);
    check_same(grid, position, radius);
  }
  // A state that is not finite any more must not crash the search; the run ends at its next check.
  const test::WithoutTraps numbers_may_be_none;
  for (const double nothing : {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), -1e300}) {
    CAPTURE(nothing);
    position.col(5).setConstant(nothing);
    for (const BallPair& pair : grid.pairs(position, radius)) CHECK(pair.first < pair.second);
  }
}

TEST_CASE("pairs at the very edge of touching are not lost to rounding, wherever they are") {
  NeighbourGrid grid;
  Random random{std::mt19937_64(11)};
  for (int n = 0; n < 20000; ++n) {
    // Two balls whose overlap is a few roundings of their distance, in any direction.
    const double size = std::pow(10, random(-3, 7));
    const Eigen::VectorXd radius = Eigen::Vector2d(random(0.01, 1), random(0.01, 1));
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random(-1, 1), random(-1, 1), random(-1, 1)).normalized();
    Eigen::Matrix3Xd position(3, 2);
    position.col(0) = size * Eigen::Vector3d(random(-1, 1), random(-1, 1), random(-1, 1));
    position.col(1) = position.col(0) + radius.sum() * (1 - random(-4, 4) * 2e-16) * direction;
    check_same(grid, position, radius);
  }
}
