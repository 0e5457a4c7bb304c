// Ball against ball, and very many of them.

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <string>

#include "05_ball_collision/ball_collision.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "physics/stability.hpp"
#include "random_numbers.hpp"
#include "rounding.hpp"
#include "run_program.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::epsilon;

namespace {

BallCollision two(double mass1, double mass2) {
  BallCollision scene;
  scene.gravity = 0;
  scene.floor = false;
  scene.mass.resize(2);
  scene.mass << mass1, mass2;
  scene.radius = Eigen::VectorXd::Constant(2, 0.1);
  return scene;
}

}  // namespace

TEST_CASE("hard case: centres that nearly coincide part along their line, and keep the momentum") {
  for (const double d : {1e-3, 1e-6, 1e-9, 1e-12, 1e-99, 1e-300, 5e-324}) {
    const BallCollision scene = two(1, 2);
    State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 2)};
    balls.position(0, 0) = d;
    const double energy = scene.energy(balls).total();
    for (int i = 0; i < 1000; ++i) rk4(scene, 0, balls, 1e-4);
    CAPTURE(d);
    CHECK(balls.velocity.allFinite());
    CHECK(scene.momentum(balls).norm() < 1000 * 4 * epsilon * 20);  // of 20 kg m/s each
    // They are thrown apart with the energy that a spring of two radii has.
    CHECK(std::abs(scene.energy(balls).total() / energy - 1) < 1e-5);
    const double apart = (balls.velocity.col(0) - balls.velocity.col(1)).norm();
    CHECK(apart == doctest::Approx((0.2 - d) * std::sqrt(1e4 / (2.0 / 3))).epsilon(1e-5));
    const int axis = d > 1e-100 ? 0 : 1;  // too near for a direction: the first one goes up
    CHECK(balls.velocity(axis, 0) > 10);
  }
}

TEST_CASE("hard case: a mass ratio of 1e6 conserves momentum, and the light one is thrown at 2 v") {
  for (const double ratio : {1e6, 1e-6}) {
    const BallCollision scene = two(1, ratio);
    State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 2)};
    balls.position(0, 0) = -0.21;
    balls.velocity(0, 0) = 1;
    const double reduced = ratio / (1 + ratio);
    const double dt = comfortable_step(natural_frequency(1e4, reduced), 0);
    const auto steps = static_cast<int>(0.03 / dt);
    for (int i = 0; i < std::max(steps, 1000); ++i) semi_implicit_euler(scene, 0, balls, dt);
    const double v1 = (1 - ratio) / (1 + ratio), v2 = 2 / (1 + ratio);
    CAPTURE(ratio);
    // The step promises a restitution of 1 +- 0.0013 (omega0 dt = 0.1).
    CHECK(std::abs(balls.velocity(0, 0) - v1) < 0.0013 * 2 * reduced);
    CHECK(std::abs(balls.velocity(0, 1) - v2) < 0.0013 * 2 / (1 + ratio));
    // Momentum: the two forces are opposite to the bit; only the two velocities are rounded.
    CHECK(std::abs(scene.momentum(balls).x() - 1) < std::max(steps, 1000) * 4 * epsilon);
  }
}

TEST_CASE("hard case: the order in which the balls are named does not matter, to 1e-12") {
  // A heap collapses in a tray. Balls that collide are chaotic: with a damper of 20 N s/m a
  // difference doubles every 40 ms (5e-16 m after 0.2 s, 1e-9 m after 1 s), with 200 N s/m half as
  // fast; no program can keep two orders together for ever.
  struct Collapse {
    double damping;
    int steps;  // of 1e-4 s
  };
  for (const Collapse& collapse : {Collapse{20, 1000}, Collapse{200, 5000}}) {
    const double damping = collapse.damping;
    std::mt19937_64 random(5);
    const auto anywhere = [&random] { return test::uniform(random, 0.1, 1.2); };
    constexpr int count = 150;
    BallCollision scene;
    scene.damping = scene.floor_damping = damping;
    scene.tray = {1.3, 1.3};
    scene.mass.resize(count);
    scene.radius.resize(count);
    State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
    for (int i = 0; i < count; ++i) {
      scene.mass[i] = anywhere();
      scene.radius[i] = 0.1 * anywhere();
      for (int axis = 0; axis < 3; ++axis) {
        balls.position(axis, i) = anywhere();
        balls.velocity(axis, i) = anywhere() - 0.6;
      }
    }
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    test::shuffle(order.begin(), order.end(), random);
    BallCollision other = scene;
    State<Eigen::Matrix3Xd> shuffled = balls;
    for (int i = 0; i < count; ++i) {
      const int from = order[static_cast<std::size_t>(i)];
      other.mass[i] = scene.mass[from];
      other.radius[i] = scene.radius[from];
      shuffled.position.col(i) = balls.position.col(from);
      shuffled.velocity.col(i) = balls.velocity.col(from);
    }
    const double before = scene.energy(balls).total();
    for (int step = 0; step < collapse.steps; ++step) {
      semi_implicit_euler(scene, 0, balls, 1e-4);
      semi_implicit_euler(other, 0, shuffled, 1e-4);
    }
    CAPTURE(damping);
    CHECK(scene.energy(balls).total() < (damping == 200 ? 0.15 : 0.6) * before);  // it did collapse
    for (int i = 0; i < count; ++i) {
      const int from = order[static_cast<std::size_t>(i)];
      CAPTURE(i);
      // A step's rounding is some 1e-16 m/s, and grows as said above: by some 2^3 and 2^6.
      CHECK((shuffled.velocity.col(i) - balls.velocity.col(from)).norm() < 1e-12);
      CHECK((shuffled.position.col(i) - balls.position.col(from)).norm() < 1e-12);
    }
  }
}

TEST_CASE("hard case: two touches at the same instant are one mirror image, to the bit") {
  // A ball between two that come from both sides: both touches fall into the same step.
  BallCollision scene;
  scene.gravity = 0;
  scene.floor = false;
  scene.mass = Eigen::VectorXd::Ones(3);
  scene.radius = Eigen::VectorXd::Constant(3, 0.1);
  State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd::Zero(3, 3), Eigen::Matrix3Xd::Zero(3, 3)};
  balls.position(0, 0) = -0.5, balls.position(0, 2) = 0.5;
  balls.velocity(0, 0) = 2, balls.velocity(0, 2) = -2;
  for (int i = 0; i < 1000; ++i) semi_implicit_euler(scene, 0, balls, 1e-3);
  CHECK(balls.position(0, 1) == 0);
  CHECK(balls.velocity(0, 1) == 0);
  CHECK(balls.position(0, 0) == -balls.position(0, 2));
  CHECK(balls.velocity(0, 2) > 1.9);
}

namespace {

/// 1e5 balls in a row along x, `spacing` apart, that all would be at x = 0 after 10 ms. Runs them,
/// with a trace, and says how long it took.
test::Outcome run_row(double spacing, bool moves, double& seconds) {
  const std::string file =
      std::string(BOUNCE_BIN_DIR) + "/crowd_of_balls_" + std::to_string(moves) + ".csv";
  {
    std::ofstream balls(file);
    balls << "mass,radius,x,y,z,vx,vy,vz\n";
    for (int i = 0; i < 100000; ++i) {
      const double x = i * spacing;
      balls << "1,0.1," << x << ",1,0," << (moves ? -x / 0.01 : 0) << ",0,0\n";
    }
  }
  const auto start = std::chrono::steady_clock::now();
  const test::Outcome run = test::run_program(
      "05_ball_collision --headless --duration 0.02 --sample 0.02 --csv out.csv --balls " +
      test::quoted(file));
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::remove(file.c_str());
  return run;
}

}  // namespace

TEST_CASE("hard case: 1e5 balls in one place are refused, in bounded time and memory") {
  double seconds = 0;
  const test::Outcome run = run_row(1e-7, false, seconds);
  CAPTURE(run.err);
  CHECK(run.code == 2);
  CHECK(run.err.find("pairs") != std::string::npos);
  CHECK(seconds < 20);  // all 5e9 pairs would take minutes, and 40 GB
}

TEST_CASE(
    "hard case: 1e5 balls that fly into one place are refused there, and nothing is written") {
  double seconds = 0;
  const test::Outcome run = run_row(0.25, true, seconds);
  CAPTURE(run.err);
  CHECK(run.code == 2);
  CHECK(run.err.find("more than 40000000 neighbours") != std::string::npos);
  CHECK(!std::filesystem::exists(test::work_folder() + "/out.csv"));
  CHECK(seconds < 60);  // some seconds; several times that under the sanitizers
}
