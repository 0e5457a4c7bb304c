#include "many_balls/many_balls.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "floating_point_traps.hpp"
#include "many_balls/crowds.hpp"
#include "physics/methods/stepping_methods.hpp"

using namespace bounce;
using many::ManyBalls;
using many::Stepping;
using Balls = State<Eigen::Matrix3Xd>;

namespace {

struct Variant {
  std::string name;
  many::PassFunction pass;
};

/// All variants of the pass that this processor can run.
std::vector<Variant> variants() {
  std::vector<Variant> all{{"scalar", many::pass_scalar}, {"vector", many::pass_vector}};
#if BOUNCE_WIDER_PASSES
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back({"avx2", many::pass_avx2});
  if (many::fastest_pass() == many::pass_avx512) all.push_back({"avx512", many::pass_avx512});
#endif
  return all;
}

/// Stage 5's own loop.
void move_plainly(test::Crowd& crowd, Stepping stepping, int steps, double dt) {
  VelocityVerlet<Eigen::Matrix3Xd> verlet;
  for (int i = 0; i < steps; ++i) {
    if (stepping == Stepping::velocity_verlet) verlet(crowd.scene, 0, crowd.balls, dt);
    if (stepping != Stepping::velocity_verlet) {
      semi_implicit_euler(crowd.scene, 0, crowd.balls, dt);
    }
  }
}

void move_fast(ManyBalls& fast, test::Crowd& crowd, Stepping stepping, int steps, double dt,
               int threads = 1) {
  Eigen::Matrix3Xd acceleration;
  fast.move(crowd.laws(), crowd.scene.mass, crowd.scene.radius, crowd.balls, acceleration, stepping,
            steps, dt, threads);
}

void check_equal(const test::Crowd& a, const test::Crowd& b) {
  CHECK(a.balls.position == b.balls.position);
  CHECK(a.balls.velocity == b.balls.velocity);
}

/// All variants, on one and on several threads, against stage 5's loop: not a bit may differ.
void check_against_plain(const test::Crowd& start, int steps, double dt) {
  for (const Stepping stepping : {Stepping::velocity_verlet, Stepping::semi_implicit_euler}) {
    test::Crowd plain = start;
    move_plainly(plain, stepping, steps, dt);
    for (const Variant& variant : variants()) {
      for (const int threads : {1, 2, 3}) {
        CAPTURE(variant.name);
        CAPTURE(threads);
        CAPTURE(stepping == Stepping::velocity_verlet);
        ManyBalls fast;
        fast.use_pass(variant.pass);
        test::Crowd crowd = start;
        move_fast(fast, crowd, stepping, steps, dt, threads);
        check_equal(crowd, plain);
      }
    }
  }
}

/// Balls of all sizes and masses thrown together, many of them overlapping.
test::Crowd mixed(int count, double size, std::uint64_t seed) {
  std::mt19937_64 chance(seed);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(chance() >> 11) * 0x1p-53;
  };
  Arrangement start(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    start.mass[i] = random(0.5, 5);
    start.radius[i] = random(0.02, 0.1);
    for (int axis = 0; axis < 3; ++axis) {
      start.balls.position(axis, i) = random(0, size);
      start.balls.velocity(axis, i) = random(-2, 2);
    }
  }
  return test::crowd_of(start, 1e4, 20, {size, 0});
}

}  // namespace

TEST_CASE("many balls: a thousand collapse as in stage 5's loop, to the last bit") {
  test::Crowd plain = test::collapse(1000);
  const test::Crowd start = plain;
  move_plainly(plain, Stepping::velocity_verlet, 1000, 1e-4);
  CHECK(test::contacts(plain) > 1000);
  for (const Variant& variant : variants()) {
    for (const int threads : {1, 2}) {
      CAPTURE(variant.name);
      CAPTURE(threads);
      ManyBalls balls;
      balls.use_pass(variant.pass);
      test::Crowd crowd = start;
      move_fast(balls, crowd, Stepping::velocity_verlet, 1000, 1e-4, threads);
      check_equal(crowd, plain);
      CHECK(balls.lists_built() > 10);
      CHECK(balls.lists_built() < 200);
    }
  }
}

TEST_CASE("many balls: any number of them, both laws, with and without floor and walls") {
  for (const int count : {1, 2, 3, 7, 8, 9, 16, 31, 130}) {
    CAPTURE(count);
    test::Crowd crowd = test::collapse(count);
    check_against_plain(crowd, 300, 1e-4);
    crowd.scene.contact = ContactLaw::push_only;
    crowd.scene.floor = false;
    crowd.scene.tray[1] = 0;
    crowd.scene.gravity = 0;
    check_against_plain(crowd, 300, 3e-4);
  }
}

TEST_CASE("many balls: of all sizes and masses, at rest upon each other and far apart") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    test::Crowd crowd = mixed(120, 0.8, seed);
    crowd.scene.radius[17] = 0.4;  // one that holds many of the others
    check_against_plain(crowd, 200, 2e-4);
    // Some are lost.
    crowd.balls.position.col(3) = Eigen::Vector3d(1e7, 1, 0.1);
    crowd.balls.position.col(90) = Eigen::Vector3d(1e7, 1.05, 0.1);
    crowd.balls.position.col(55) = Eigen::Vector3d(-1e15, 1, 1e15);
    crowd.scene.tray = {0, 0};
    check_against_plain(crowd, 200, 2e-4);
  }
}

TEST_CASE("many balls: where centres coincide, the one with the lower number goes up") {
  test::Crowd crowd = mixed(40, 1, 5);
  crowd.balls.position.col(20) = crowd.balls.position.col(7);
  crowd.balls.velocity.col(20) = crowd.balls.velocity.col(7);
  crowd.balls.position.col(21) = crowd.balls.position.col(7);  // all three
  crowd.scene.radius.setConstant(0.1);
  check_against_plain(crowd, 1, 1e-4);
  check_against_plain(crowd, 100, 1e-4);
}

TEST_CASE("many balls: one call or many, and balls that are put elsewhere in between") {
  for (const Stepping stepping : {Stepping::velocity_verlet, Stepping::semi_implicit_euler}) {
    test::Crowd plain = test::collapse(200), fast = plain;
    ManyBalls balls;
    VelocityVerlet<Eigen::Matrix3Xd> verlet;
    Eigen::Matrix3Xd acceleration;
    for (int call = 0; call < 120; ++call) {
      const int steps = 1 + call % 5;
      for (int i = 0; i < steps; ++i) {
        if (stepping == Stepping::velocity_verlet) verlet(plain.scene, 0, plain.balls, 1e-4);
        if (stepping != Stepping::velocity_verlet) {
          semi_implicit_euler(plain.scene, 0, plain.balls, 1e-4);
        }
      }
      balls.move(fast.laws(), fast.scene.mass, fast.scene.radius, fast.balls, acceleration,
                 stepping, steps, 1e-4, 1 + call / 50);
      check_equal(fast, plain);
      if (call % 9 != 8) continue;
      const double much = call % 2 == 0 ? 0.003 : 1.5;  // m
      for (test::Crowd* crowd : {&plain, &fast}) {
        crowd->balls.position.col(call).y() += much;
        crowd->balls.position.col(call + 1).x() += much / 7;
        crowd->scene.radius[call] *= 1.1;
      }
    }
    CHECK(balls.lists_built() < 120);
    const ManyBalls copy = balls;  // and a copy knows nothing of the list
    CHECK(copy.lists_built() == 0);
  }
}

TEST_CASE("many balls: quotients whose remainder would underflow are divided, to the last bit") {
  // Were they not, AVX2 and AVX-512 would differ from the loop in the last bits of x.
  test::Crowd crowd = test::collapse(64);
  crowd.scene.tray = {0, 0};
  std::mt19937_64 chance(5);
  for (Eigen::Index i = 0; i < 64; ++i) {
    const double x = std::ldexp(1 + static_cast<double>(chance() >> 11) * 0x1p-53, -1018);
    crowd.balls.position.col(i) = Eigen::Vector3d(x, 0.07 * static_cast<double>(i), 0);
    crowd.balls.velocity.col(i).setZero();
  }
  check_against_plain(crowd, 3, 1e-4);
}

TEST_CASE("many balls: a state that is no number does no harm, and the next run starts anew") {
  const test::WithoutTraps nan_on_purpose;
  test::Crowd start = test::collapse(100), plain = start, crowd = start;
  ManyBalls balls;
  crowd.balls.position(1, 50) = std::numeric_limits<double>::quiet_NaN();
  crowd.balls.velocity(0, 3) = std::numeric_limits<double>::infinity();
  crowd.balls.position(2, 60) = 1e300;
  for (const int threads : {1, 2}) {
    move_fast(balls, crowd, Stepping::velocity_verlet, 50, 1e-4, threads);
  }
  CHECK(!crowd.balls.position.allFinite());
  crowd.balls = start.balls;
  move_plainly(plain, Stepping::velocity_verlet, 200, 1e-4);
  move_fast(balls, crowd, Stepping::velocity_verlet, 200, 1e-4);
  check_equal(crowd, plain);
}

TEST_CASE("many balls: momentum is kept to rounding, and energy in a band of second order") {
  double drift[2];
  for (const int half : {0, 1}) {
    test::Crowd crowd = mixed(400, 1, 8);
    crowd.scene.gravity = crowd.scene.damping = 0;
    crowd.scene.floor = false;
    crowd.scene.tray = {0, 0};
    const Eigen::Vector3d momentum = crowd.scene.momentum(crowd.balls);
    const double energy = crowd.scene.energy(crowd.balls).total();
    const int steps = 1000 << half;
    ManyBalls balls;
    move_fast(balls, crowd, Stepping::velocity_verlet, steps, 1e-4 / (1 << half), 2);
    // A few roundings of 1e-16 m v each step and ball, m v below 100 kg m/s, as a random walk.
    const double tolerance = 4 * 1.2e-16 * 100 * std::sqrt(400.0 * steps);
    CHECK((crowd.scene.momentum(crowd.balls) - momentum).norm() < tolerance);
    drift[half] = std::abs(crowd.scene.energy(crowd.balls).total() / energy - 1);
  }
  INFO("energy drift ", drift[0], ", with half the step ", drift[1]);
  // The stiffest pair has omega0 = 200/s: (omega0 dt)^2 / 8 = 5e-5, and meetings in between steps
  // add a few of that.
  CHECK(drift[0] < 5e-4);
  CHECK(drift[1] < 2e-4);
}
