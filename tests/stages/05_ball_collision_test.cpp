#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "03_damping/damping.hpp"
#include "05_ball_collision/files/balls_file.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "methods.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "random_numbers.hpp"
#include "run_with.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::set;

namespace {

using Balls = State<Eigen::Matrix3Xd>;
using Step = std::function<void(const BallCollision&, double, Balls&, double)>;

struct Method4 {
  std::string name;
  std::function<Step()> make;
  int order;  // inside a contact, where the force is smooth
};

const std::vector<Method4>& methods4() {
  using M = Eigen::Matrix3Xd;
  static const std::vector<Method4> all{
      {"explicit-euler", [] { return Step(explicit_euler<BallCollision, M>); }, 1},
      {"semi-implicit-euler", [] { return Step(semi_implicit_euler<BallCollision, M>); }, 1},
      {"velocity-verlet", [] { return Step(VelocityVerlet<M>{}); }, 2},
      {"rk4", [] { return Step(rk4<BallCollision, M>); }, 4}};
  return all;
}

struct OneBall {
  double mass, radius;
  Vector3d position, velocity;
};

/// Balls in empty space.
struct Run {
  BallCollision scene;
  Balls state;

  explicit Run(const std::vector<OneBall>& balls, double stiffness = 1e4, double damping = 0) {
    const auto count = static_cast<Eigen::Index>(balls.size());
    scene.gravity = 0;
    scene.floor = false;
    scene.stiffness = stiffness;
    scene.damping = damping;
    scene.mass.resize(count);
    scene.radius.resize(count);
    state.position.resize(3, count);
    state.velocity.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const OneBall& ball = balls[static_cast<std::size_t>(i)];
      scene.mass[i] = ball.mass;
      scene.radius[i] = ball.radius;
      state.position.col(i) = ball.position;
      state.velocity.col(i) = ball.velocity;
    }
  }
  void go(const Step& step, double dt, int steps) {
    for (int i = 0; i < steps; ++i) step(scene, i * dt, state, dt);
  }
  double x_speed(Eigen::Index ball) const { return state.velocity(0, ball); }
};

const Step slides_loop = semi_implicit_euler<BallCollision, Eigen::Matrix3Xd>;

/// Balls thrown together at random, many of them overlapping.
Run crowd(unsigned seed, int count, double size) {
  std::mt19937_64 generator(seed);
  const auto random = [&](double low, double high) { return test::uniform(generator, low, high); };
  std::vector<OneBall> balls;
  for (int i = 0; i < count; ++i) {
    balls.push_back({random(0.5, 2), random(0.05, 0.15),
                     Vector3d(random(0, size), random(0, size), random(0, size)),
                     Vector3d(random(-1, 1), random(-1, 1), random(-1, 1))});
  }
  return Run(balls);
}

}  // namespace

TEST_CASE("stage 5: the force on ball 1 is +k (r1 + r2 - d) e12, with e12 from ball 2 to ball 1") {
  const Ball ball1{{0, 0, 0}, {0, 0, 0}, 0.1}, ball2{{0.12, 0.09, 0}, {0, 0, 0}, 0.08};
  const Vector3d force = pair_force(ball1, ball2, {1e4, 0});
  // d = 0.15, overlap 0.03, and ball 2 lies in the direction (0.8, 0.6): ball 1 is pushed away.
  INFO("got ", force.transpose(), ": with the other sign the balls would attract each other");
  CHECK((force - 300 * Vector3d(-0.8, -0.6, 0)).norm() < 1e-11);  // 300 N, a few roundings
  CHECK(pair_force(ball2, ball1, {1e4, 0}) == -force);
}

TEST_CASE("stage 5: the damper acts on the normal relative velocity only") {
  const SpringDamper contact{1e4, 7};
  const auto force = [&](const Vector3d& v1, const Vector3d& v2) {
    return pair_force({{0, 0, 0}, v1, 0.1}, {{0.15, 0, 0}, v2, 0.1}, contact).eval();
  };
  const Vector3d spring = force({0, 0, 0}, {0, 0, 0});
  INFO("sliding along each other is no approach");
  CHECK(force({0, 2, -1}, {0, -3, 5}) == spring);
  INFO("moving together is no approach");
  CHECK(force({3, 0, 0}, {3, 0, 0}) == spring);
  INFO("closing at 2 m/s adds c v = 14 N");
  CHECK(force({1, 0, 0}, {-1, 0, 0}).x() - spring.x() == doctest::Approx(-14).epsilon(1e-12));
}

TEST_CASE("stage 5: momentum is kept to rounding, with every method, dampers or none") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    for (const Method4& method : methods4()) {
      for (const double damping : {0.0, 30.0}) {
        Run run = crowd(seed, 40, 0.7);
        run.scene.damping = damping;
        const Vector3d before = run.scene.momentum(run.state);
        const int steps = 1000;
        run.go(method.make(), 2e-4, steps);
        // A step rounds the velocity of each ball a few times, and forces that cancel exactly were
        // divided by two masses: 4 roundings of 2e-16 m v each, with m v below 60 kg m/s (deep
        // overlaps throw the balls apart at up to 30 m/s), growing at most with the steps' number.
        const double tolerance = steps * 40 * 4 * 1.2e-16 * 60;
        INFO(method.name, " seed ", seed, " damping ", damping);
        CHECK((run.scene.momentum(run.state) - before).norm() < tolerance);
        CHECK(run.state.velocity.allFinite());
      }
    }
  }
}

TEST_CASE("stage 5: without damping the energy error falls with the method's order") {
  // A crowd that presses itself apart: the force has a kink wherever two balls meet or part, so
  // that no method is better than second order here (docs/02_spring_floor.md).
  for (const auto& [name, expected] : {std::pair{1, 1.0}, std::pair{2, 2.0}, std::pair{3, 2.0}}) {
    const Method4& method = methods4()[static_cast<std::size_t>(name)];
    std::vector<double> dts, errors;
    for (const double dt : {4e-4, 2.8e-4, 2e-4, 1.4e-4, 1e-4, 0.7e-4, 0.5e-4}) {
      double error = 0;
      for (const unsigned seed : {1u, 2u, 3u, 4u}) {
        Run run = crowd(seed, 30, 0.5);
        const double before = run.scene.energy(run.state).total();
        run.go(method.make(), dt, static_cast<int>(std::lround(0.05 / dt)));
        error += std::abs(run.scene.energy(run.state).total() / before - 1);
      }
      dts.push_back(dt);
      errors.push_back(error);
    }
    const double order = test::fitted_slope(dts, errors);
    INFO(method.name, ": measured order ", order, ", error at the largest dt ", errors.front());
    // Semi-implicit Euler keeps its energy in a band of first order and, when all have parted, of
    // second order; the kinks scatter the fit by about 0.4.
    CHECK(order > expected - 0.4);
    // omega0 dt = 0.04 (two balls of 0.5 kg: 200/s... 4e-4 s): first order gives at most that.
    CHECK(errors.front() / 4 < 0.04);
  }
}

TEST_CASE("stage 5: inside a contact every method has its full order, against the formula") {
  // Head-on, starting at the touch: overlap = (v / w) sin(w t) with w = sqrt(k / m_eff).
  const double m1 = 1, m2 = 3, v = 2, m_eff = m1 * m2 / (m1 + m2);
  const double w = std::sqrt(1e4 / m_eff), t = 0.7 * std::acos(-1.0) / w;
  for (const Method4& method : methods4()) {
    std::vector<double> dts, errors;
    for (const int steps : {40, 56, 80, 113, 160}) {
      Run run({{m1, 0.1, {-0.1, 0, 0}, {v, 0, 0}}, {m2, 0.1, {0.1, 0, 0}, {0, 0, 0}}});
      run.go(method.make(), t / steps, steps);
      const double distance = (run.state.position.col(0) - run.state.position.col(1)).norm();
      const double closing = run.x_speed(0) - run.x_speed(1);
      dts.push_back(t / steps);
      // (Semi-implicit Euler has the overlap to second order from here, and only the speed to
      // first.)
      errors.push_back(w * std::abs(0.2 - distance - v / w * std::sin(w * t)) +
                       std::abs(closing - v * std::cos(w * t)));
    }
    const double order = test::fitted_slope(dts, errors);
    INFO(method.name, ": measured order ", order);
    CHECK(std::abs(order - method.order) < 0.15);  // the next term of the error, at w dt = 0.05
  }
}

TEST_CASE("stage 5: equal balls exchange their velocities head-on") {
  for (const Method4& method : methods4()) {
    for (const double w_dt : {0.1, 0.037, 0.01}) {
      const double dt = w_dt / std::sqrt(2 * 1e4);  // m_eff = 1/2
      Run run({{1, 0.1, {-0.15, 0, 0}, {1.5, 0, 0}}, {1, 0.1, {0.15, 0, 0}, {-0.5, 0, 0}}});
      run.go(method.make(), dt, static_cast<int>(0.15 / dt));
      // Restitution of an undamped contact: 1 +- 0.12 (w dt)^2 by where in a step the touch falls
      // (stability.hpp), for explicit Euler up to exp(pi w dt / 2); it acts on half of the 2 m/s.
      const bool is_explicit = method.name == "explicit-euler";
      const double tolerance =
          is_explicit ? 1.1 * std::expm1(1.5708 * w_dt) + w_dt * w_dt : 0.2 * w_dt * w_dt;
      INFO(method.name, " w dt = ", w_dt, " got ", run.x_speed(0), " and ", run.x_speed(1));
      CHECK(std::abs(run.x_speed(0) + 0.5) < tolerance);
      CHECK(std::abs(run.x_speed(1) - 1.5) < tolerance);
    }
  }
}

TEST_CASE("stage 5: unequal balls, with and without dampers, both laws, against the formula") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const double zeta : {0.0, 0.1, 0.5}) {
      for (const double m2 : {0.1, 1.0, 7.0}) {
        for (const double w_dt : {4e-3, 1.3e-3}) {
          const double m1 = 1, m_eff = m1 * m2 / (m1 + m2), k = 1e4;
          const double c = 2 * zeta * std::sqrt(k * m_eff), dt = w_dt / std::sqrt(k / m_eff);
          Run run({{m1, 0.1, {-0.2, 0, 0}, {2, 0, 0}}, {m2, 0.05, {0, 0, 0}, {-1, 0, 0}}}, k, c);
          run.scene.contact = law;
          run.go(slides_loop, dt, static_cast<int>(0.15 / dt));
          const double e = restitution({k, c, law}, m_eff);
          const double common = (m1 * 2 - m2 * 1) / (m1 + m2);
          const double v1 = common - e * m2 / (m1 + m2) * 3, v2 = common + e * m1 / (m1 + m2) * 3;
          INFO("m2 = ", m2, " zeta = ", zeta, " w dt = ", w_dt, ": got ", run.x_speed(0), ", ",
               run.x_speed(1), ", expected ", v1, ", ", v2);
          // As in stage 3: the touch is seen up to a step late, where the damper's force jumps.
          const double tolerance = 3 * (0.5 + 4 * zeta) * w_dt;
          CHECK(std::abs(run.x_speed(0) - v1) < tolerance);
          CHECK(std::abs(run.x_speed(1) - v2) < tolerance);
        }
      }
    }
  }
}

TEST_CASE("stage 5: an oblique impact leaves the tangential velocity alone") {
  for (const Method4& method : methods4()) {
    INFO(method.name);
    // Both slide along the plane of contact together: not a bit of that may change.
    Run together({{1, 0.1, {-0.12, 0, 0}, {1, 0.25, -2}}, {2, 0.1, {0.12, 0, 0}, {0, 0.25, -2}}},
                 1e4, 20);
    together.go(method.make(), 1e-4, 2000);
    CHECK(std::abs(together.x_speed(1)) > 0.1);  // they did collide
    for (const Eigen::Index ball : {0, 1}) {
      CHECK(together.state.velocity(1, ball) == 0.25);
      CHECK(together.state.velocity(2, ball) == -2);
    }
  }
  // Off centre, the line of centres turns during the contact. The force is along it, so it has no
  // torque: what one ball's path misses the other by, times their speed, stays. When they part they
  // are as far apart as when they met, so the speed along the plane of contact is the same again.
  for (const double damping : {0.0, 30.0}) {
    for (const double miss : {0.02, 0.08, 0.15}) {
      Run run({{1, 0.1, {-0.25, 0, miss}, {2, 0, 0}}, {1, 0.1, {0, 0, 0}, {0, 0, 0}}}, 1e4,
              damping);
      const auto spin = [&] {
        const Vector3d between = run.state.position.col(0) - run.state.position.col(1);
        const Vector3d speed = run.state.velocity.col(0) - run.state.velocity.col(1);
        return between.cross(speed).y();
      };
      const double before = spin();
      run.go(slides_loop, 1e-4, 3000);
      CAPTURE(miss);
      CAPTURE(damping);
      // Semi-implicit Euler keeps it step by step; rounding adds 2e-16 x 0.6 m x 2 m/s each time.
      CHECK(std::abs(spin() - before) < 3000 * 4e-16);
      CHECK(run.state.velocity(0, 0) < 1.99);
    }
  }
}

TEST_CASE("stage 5: three touching balls do not hand a push on whole; with gaps they do") {
  // Two balls at rest that touch, and a third that comes in: for equal springs the ratios of the
  // speeds afterwards do not depend on k, m and v0. Three more digits than the simulation needs,
  // from the springs' equations solved between changes of contact.
  const double right[] = {-0.130262, 0.150230, 0.980032};
  const double k = 1e4, v0 = 0.7, omega0 = std::sqrt(k);
  for (const double w_dt : {2e-3, 7e-4}) {
    Run run({{1, 0.1, {-0.2, 0, 0}, {v0, 0, 0}},
             {1, 0.1, {0, 0, 0}, {0, 0, 0}},
             {1, 0.1, {0.2, 0, 0}, {0, 0, 0}}},
            k);
    run.go(VelocityVerlet<Eigen::Matrix3Xd>{}, w_dt / omega0, static_cast<int>(20 / w_dt));
    for (const Eigen::Index ball : {0, 1, 2}) {
      INFO("ball ", ball, " w dt = ", w_dt, ": got ", run.x_speed(ball) / v0);
      // Half a digit of the numbers above, and the method's (w dt)^2.
      CHECK(std::abs(run.x_speed(ball) / v0 - right[ball]) < 5e-7 + w_dt * w_dt);
    }
  }
  // While two balls touch, pi sqrt(m_eff / k), the struck one moves at v0 / 2 on average: 7.8 mm,
  // pi/2 times the greatest overlap. With wider gaps only one pair touches at a time, and the push
  // arrives whole. (With a gap of just the overlap, 4.95 mm, it does to 0.2 %.)
  const double w_dt = 1e-3;
  for (const auto& row : {std::pair{0.008, w_dt * w_dt}, std::pair{0.00496, 0.002}}) {
    const double gap = row.first, tolerance = row.second;
    Run apart({{1, 0.1, {-0.21, 0, 0}, {v0, 0, 0}},
               {1, 0.1, {0, 0, 0}, {0, 0, 0}},
               {1, 0.1, {0.2 + gap, 0, 0}, {0, 0, 0}}},
              k);
    apart.go(VelocityVerlet<Eigen::Matrix3Xd>{}, w_dt / omega0, static_cast<int>(20 / w_dt));
    for (const Eigen::Index ball : {0, 1, 2}) {
      INFO("gap ", gap, " ball ", ball, ": got ", apart.x_speed(ball) / v0);
      CHECK(std::abs(apart.x_speed(ball) / v0 - (ball == 2 ? 1 : 0)) < tolerance);
    }
  }
}

TEST_CASE("stage 5: a ball that hits two touching balls squarely leaves them mirror-symmetric") {
  for (const Method4& method : methods4()) {
    for (const double dt : {1e-3, 3.3e-4}) {
      for (const double damping : {0.0, 15.0}) {
        Run run({{1.7, 0.11, {-0.3, 0, 0}, {2, 0, 0}},
                 {0.6, 0.1, {0, 0, 0.1}, {0, 0, 0}},
                 {0.6, 0.1, {0, 0, -0.1}, {0, 0, 0}}},
                1e4, damping);
        run.go(method.make(), dt, 500);
        INFO(method.name, " dt = ", dt, " damping ", damping);
        CHECK(run.x_speed(1) > 0.1);
        CHECK(run.state.position(0, 1) == run.state.position(0, 2));
        CHECK(run.state.position(2, 1) == -run.state.position(2, 2));
        CHECK(run.state.velocity(0, 1) == run.state.velocity(0, 2));
        CHECK(run.state.velocity(2, 1) == -run.state.velocity(2, 2));
        CHECK(run.state.position(2, 0) == 0);
        CHECK(run.state.velocity(2, 0) == 0);
      }
    }
  }
}

TEST_CASE("stage 5: a near miss by 1e-9 m feels no force at all") {
  for (const Method4& method : methods4()) {
    Run run({{1, 0.1, {-0.3, 0, 0.2 + 1e-9}, {1, 0, 0}}, {2, 0.1, {0, 0, 0}, {0, 0, 0}}}, 1e9, 50);
    run.go(method.make(), 1e-3, 600);
    INFO(method.name);
    CHECK(run.state.velocity.col(0) == Vector3d(1, 0, 0));
    CHECK(run.state.velocity.col(1) == Vector3d(0, 0, 0));
    CHECK(run.state.position(0, 0) > 0.2);  // it did pass
    // And a hit by 1e-9 m does feel one.
    Run hit({{1, 0.1, {-0.3, 0, 0.2 - 1e-9}, {1, 0, 0}}, {2, 0.1, {0, 0, 0}, {0, 0, 0}}}, 1e9, 0);
    hit.go(method.make(), 1e-6, 400000);
    CHECK(hit.state.velocity(2, 0) > 0);
  }
}

TEST_CASE("stage 5: coincident centres: the ball with the lower number goes up, nothing is NaN") {
  for (const double apart : {0.0, 1e-320, 1e-200}) {
    for (const double damping : {0.0, 10.0}) {
      Run run({{1, 0.1, {0, 0, 0}, {0, 0, 0}}, {2, 0.1, {apart, 0, 0}, {0, 0, 0}}}, 1e4, damping);
      const Eigen::Matrix3Xd a = run.scene.acceleration(0, run.state);
      CAPTURE(apart);
      CHECK(a.col(0) == Vector3d(0, 1e4 * 0.2, 0));
      CHECK(a.col(1) == Vector3d(0, -1e4 * 0.2 / 2, 0));
      run.go(slides_loop, 1e-4, 1000);
      CHECK(run.state.velocity.allFinite());
      CHECK(run.state.velocity(1, 0) > 1);
      CHECK(run.scene.momentum(run.state).norm() < 1000 * 4e-16 * 20);
    }
  }
}

TEST_CASE("stage 5: one ball on the floor is stage 3, to the bit") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    Damping stage3;
    stage3.mass = 0.7;
    stage3.damping = 12;
    stage3.contact = law;
    Run run({{0.7, 0.1, {0, 1, 0}, {0.5, 0, 0}}});
    run.scene.gravity = stage3.gravity;
    run.scene.floor = true;
    run.scene.floor_damping = 12;
    run.scene.contact = law;
    State<double> ball{1, 0};
    for (int i = 0; i < 5000; ++i) {
      semi_implicit_euler(stage3, 0, ball, 1e-3);
      semi_implicit_euler(run.scene, 0, run.state, 1e-3);
    }
    CHECK(run.state.position(1, 0) == ball.position);
    CHECK(run.state.velocity(1, 0) == ball.velocity);
    CHECK(run.x_speed(0) == 0.5);
  }
}

TEST_CASE("stage 5: the tray's walls push with the floor's law, and a corner with both") {
  Run run({{1, 0.1, {0.1, 0.5, 1}, {0, 0, 0}}}, 1e4);
  run.scene.tray = {2, 3};
  run.scene.floor_stiffness = 500;
  run.scene.floor_damping = 4;
  const auto at = [&](const Vector3d& position, const Vector3d& velocity) {
    run.state.position.col(0) = position;
    run.state.velocity.col(0) = velocity;
    return Vector3d(run.scene.acceleration(0, run.state));
  };
  const double rounding = 1e-12;  // of overlaps of centimetres, times 500
  CHECK((at({0.04, 0.5, 1}, {0, 0, 0}) - Vector3d(30, 0, 0)).norm() < rounding);
  CHECK((at({1.94, 0.5, 1}, {0, 0, 0}) - Vector3d(-20, 0, 0)).norm() < rounding);
  CHECK((at({1.94, 0.5, 1}, {-2, 7, 7}) - Vector3d(-12, 0, 0)).norm() < rounding);
  CHECK((at({0.04, 0.5, 2.98}, {0, 0, 0}) - Vector3d(30, 0, -40)).norm() < rounding);
  CHECK((at({0.04, -5, 0.08}, {0, 0, 0}) - Vector3d(30, 0, 10)).norm() < rounding);  // no floor
  CHECK(at({0.1, 0.5, 2.9}, {1, 1, 1}) == Vector3d(0, 0, 0));
  run.scene.tray = {0, 3};  // walls along z only
  CHECK(at({-7, 0.5, 1}, {0, 0, 0}) == Vector3d(0, 0, 0));

  // A lossless ball in a lossless tray is still there after a thousand crossings.
  run.scene.tray = {2, 3};
  run.scene.floor_stiffness = 1e4;
  run.scene.floor_damping = 0;
  at({0.7, 0.5, 1.2}, {2, 0, 1.3});
  run.go(slides_loop, 1e-3, 1000000);
  CHECK(run.state.position(0, 0) > 0);
  CHECK(run.state.position(0, 0) < 2);
  CHECK(run.state.position(2, 0) > 0);
  CHECK(run.state.position(2, 0) < 3);
}

TEST_CASE("stage 5: the grid and the double loop give the same bits") {
  BallsRun simulation;
  set(simulation, "scene", "drop");
  set(simulation, "count", "150");
  simulation.restart();
  BallCollision by_grid = simulation.scene(), by_loop = simulation.scene();
  by_grid.grid_from = 0;
  by_loop.grid_from = 1000000;
  Balls a = simulation.state(), b = a;
  for (int i = 0; i < 1500; ++i) {
    semi_implicit_euler(by_grid, 0, a, 1e-3);
    semi_implicit_euler(by_loop, 0, b, 1e-3);
  }
  CHECK(by_loop.energy(b).spring > 0);  // they lie in the tray and press each other
  CHECK(a.position == b.position);
  CHECK(a.velocity == b.velocity);
  CHECK(by_grid.energy(a).total() == by_loop.energy(b).total());
  CHECK(by_grid.damper_power(a) == by_loop.damper_power(b));
}

TEST_CASE("stage 5: what the dampers take is what is missing") {
  for (const std::string scene : {"tower", "drop", "break"}) {
    BallsRun simulation;
    set(simulation, "scene", scene);
    set(simulation, "damping", "10");
    set(simulation, "floor_damping", "25");
    simulation.keep_energy_book(true);
    simulation.use_dt(5e-5);
    simulation.restart();
    simulation.advance_to(1);
    const double before = simulation.energy_account().before;
    const double error = simulation.energy().total() + simulation.energy_account().lost - before;
    INFO(scene, ": lost ", simulation.energy_account().lost, " of ", before, ", error ", error);
    CHECK(simulation.energy_account().lost > 0.05 * before);
    // First order: w dt = 0.01 at a touch, where the damper's force jumps (stage 3).
    CHECK(std::abs(error) < 0.01 * before);
  }
}

TEST_CASE("stage 5: the small ball on the big one") {
  // Ideal, with a gap: the big ball turns round at the speed it fell with, v, and meets the small
  // one that still falls with v: v_small = (3 M - m) / (M + m) v = 29/11 v, so it rises 6.95 times
  // as high as the fall. Springs that take their time come close; balls that touch share the push.
  const auto highest = [](const std::string& gap, Method method, double dt) {
    auto tower = test::run_with<BallsRun>({{"scene", "tower"}, {"gap", gap}}, method, dt);
    const auto speed = [&] { return tower.state().velocity(1, 1); };
    while (speed() < 1) tower.advance_to(tower.time() + 1e-3);  // down, and thrown up,
    while (speed() > 0) tower.advance_to(tower.time() + 1e-4);  // to the first top
    const double fall = 0.8;
    const double touching = 2 * tower.scene().radius[0] + tower.scene().radius[1];
    return (tower.state().position(1, 1) - touching) / fall;
  };
  const double touching = highest("0", methods::semi_implicit_euler, 1e-5);
  const double apart = highest("0.1", methods::semi_implicit_euler, 1e-5);
  INFO("rises ", touching, " and ", apart, " times the fall");
  // What touching balls do is no law but follows from these springs: events located, and the
  // contacts integrated to twelve digits, say the same. The loop is off by some omega0 dt (3e-3).
  CHECK(touching == doctest::Approx(highest("0", methods::reference, 1e-5)).epsilon(3e-3));
  // Apart: the ideal, and at most the gap (1/8 of the fall) times 29/11 more, because the small one
  // falls further.
  CHECK(apart > 6.9);
  CHECK(apart < 6.95 + 0.125 * 29 / 11);
}

TEST_CASE("stage 5: scenes bring defaults, and setting wins over them, in any order") {
  BallsRun simulation;
  const auto set = [&](const std::string& name, const std::string& value) {
    test::set(simulation, name, value);
  };
  const auto get = [&](const std::string& name) {
    return find_parameter(simulation.parameters(), name).text();
  };
  CHECK(get("gravity") == "0");
  set("scene", "drop");
  CHECK(get("gravity") == "9.81");
  CHECK(get("count") == "300");
  simulation.restart();
  const double width = parse_number(split(get("tray"))[0]).value();
  CHECK(width == doctest::Approx(0.8).epsilon(0.01));
  set("count", "1000");  // the tray follows the count
  simulation.restart();
  CHECK(parse_number(split(get("tray"))[0]).value() > 1.4 * width);
  set("tray", "1.5,2");  // until the user says what it is
  set("count", "64");
  simulation.restart();
  CHECK(get("tray") == "1.5,2");
  CHECK_THROWS_AS(set("count", "2.5"), BadInput);
  CHECK_THROWS_AS(set("count", "0"), BadInput);
}

TEST_CASE("stage 5: drop: the seed decides, no ball overlaps another or a wall at the start") {
  const Arrangement a = drop(500, 0.0143, {0.9, 0.7}, 1), b = drop(500, 0.0143, {0.9, 0.7}, 2);
  CHECK(a.balls.position == drop(500, 0.0143, {0.9, 0.7}, 1).balls.position);
  CHECK(a.balls.position != b.balls.position);
  for (Eigen::Index i = 0; i < 500; ++i) {
    CHECK(a.balls.position(0, i) > 0.05);
    CHECK(a.balls.position(0, i) < 0.85);
    CHECK(a.balls.position(2, i) > 0.05);
    CHECK(a.balls.position(2, i) < 0.65);
    for (Eigen::Index j = i + 1; j < 500; ++j) {
      CHECK((a.balls.position.col(i) - a.balls.position.col(j)).norm() > 0.1);
    }
  }
}

TEST_CASE("stage 5: a saved state goes on to the bit, for every scene, method and for own balls") {
  const auto path = std::filesystem::temp_directory_path() / "bounce_own_balls.csv";
  std::ofstream(path) << "mass,radius,x,y,z,vx,vy,vz\n1,0.1,0,0.5,0,1,0,0\n2,0.2,1,0.5,0,0,0,0\n";
  for (const std::string scene : {"pair", "break", "cradle", "tower", "drop", "file"}) {
    for (const Method method : BallsRun().methods()) {
      BallsRun run;
      if (scene == "file") run.world().use_balls(BallsFile(path.string()).read(), path.string());
      if (scene != "file") set(run, "scene", scene);
      const bool is_slow = scene == "drop" && method == methods::reference;
      if (is_slow) set(run, "count", "20");
      run.use_seed(7);
      run.use_method(method);
      run.restart();
      run.advance_to(0.4005);
      BallsRun other;
      if (scene != "file") set(other, "scene", scene);
      if (scene == "file") set(other, "gravity", "9.81");
      if (is_slow) set(other, "count", "20");
      other.use_method(method);
      other.restart();
      other.recall(run.memory());
      run.advance_to(0.9);
      other.advance_to(0.9);
      INFO(scene, " ", name_of(method));
      CHECK(run.values() == other.values());
      run.restart();
      other.restart();
      CHECK(run.values() == other.values());
    }
  }
  BallsRun run;
  Simulation::Memory memory = run.memory();
  memory.numbers.pop_back();
  CHECK_THROWS_AS(run.recall(memory), BadInput);
}

TEST_CASE("stage 5: the time step that is asked for fits the lightest balls") {
  BallsRun tower;
  set(tower, "scene", "tower");
  tower.restart();
  // 1 kg on the floor: 100/s. 1 kg against 10 kg: m_eff = 10/11 kg, so sqrt(1.1) times that.
  set(tower, "stiffness", "1e4");
  set(tower, "floor_stiffness", "1e4");
  CHECK(tower.contact()->omega0 == doctest::Approx(100 * std::sqrt(1.1)).epsilon(1e-12));
}
