// Floors, planes and discs that move, end, or are seen from the wrong side.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "08_racket_game/racket_game.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "run_program.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::run_program;
using SpaceBall = State<Vector3d>;

TEST_CASE("hard case: a thin disc is not tunnelled, at 400 m/s and 10 ms a step") {
  // The disc has no thickness. In a step of 10 ms a ball at 400 m/s moves by 40 of its radii.
  for (const double speed : {20.0, 100.0, 400.0}) {
    for (const double start : {0.11, 0.5, 1.7}) {
      Racket scene;
      scene.gravity = 0;
      scene.damping = 0;
      scene.stiffness = 1e8;  // presses in by v / omega0 = 4 cm at most
      scene.disc.radius = 1;
      SpaceBall naive{{0.1, start, 0}, {0, -speed, 0}}, ball = naive;
      Racket looked_at = scene;
      ContactSteps<Rk4> steps(scene);
      for (int i = 0; i < 20; ++i) {
        steps(i * 0.01, ball, 0.01);
        // Naively: the side is where the centre is, and the force is asked for at steps only.
        looked_at.side = naive.position.y() < 0 ? -1 : 1;
        semi_implicit_euler(looked_at, i * 0.01, naive, 0.01);
      }
      CAPTURE(speed);
      CAPTURE(start);
      CHECK(steps.touches == 1);
      CHECK(ball.velocity.y() == doctest::Approx(speed).epsilon(1e-6));
      CHECK(ball.position.y() > 0.1);
      if (speed == 400 && start == 1.7) CHECK(naive.velocity.y() == -400);  // straight through
    }
  }
}

TEST_CASE("hard case: a ball that is pressed in and slides off sideways gains nothing") {
  // Its centre stays on its side of the disc: there the hand-over at the rim is continuous, and
  // without a damper on a racket at rest the energy is a constant.
  for (const double x : {0.25, 0.29, 0.299}) {
    Racket scene;
    scene.damping = 0;
    SpaceBall ball{{x, 0.05, 0}, {2, -0.5, 0}};  // half a radius deep, outwards
    const double before = scene.energy(0, ball).total();
    ContactSteps<Rk4> steps(scene);
    for (int i = 0; i < 50; ++i) steps(i * 1e-3, ball, 1e-3);
    CAPTURE(x);
    CHECK(ball.position.x() > 0.3);  // it did leave over the rim
    // RK4 in pieces of omega0 dt = 1e-3; at the rim the force has a kink, passed once: order 2.
    CHECK(std::abs(scene.energy(0.05, ball).total() / before - 1) < 1e-5);
  }
}

TEST_CASE(
    "hard case: through the disc and out over its rim the push turns evenly, no energy is lost") {
  // The centre has gone through. Beside the disc the nearest point is on the rim, on the other
  // side: there the push of stage 7 and that of the rim are opposite.
  Racket scene;
  scene.damping = 0;
  const double through = 0.03;
  const SpaceBall inside{{0.3 - 1e-9, -through, 0}, {0, 0, 0}};
  const SpaceBall outside{{0.3 + 1e-9, -through, 0}, {0, 0, 0}};
  CHECK(scene.force(0, inside).y() > 1000);
  CHECK(scene.force(0, outside).y() < -500);  // of a ball that came along beside the disc
  CHECK(scene.energy(0, inside).spring - scene.energy(0, outside).spring > 50);
  // One that was pressed through is remembered. k r shift / through = 3e-5 N is how much the push
  // turns in between.
  scene.choose_side(0, inside.position);
  CHECK(scene.through);
  CHECK((scene.force(0, outside) - scene.force(0, inside)).norm() < 1e-3);
  for (const double speed : {0.5, 3.0, 8.0}) {
    Racket racket = scene;
    SpaceBall ball{{0.28, -through, 0}, {speed, 0, 0}};
    const double before = racket.energy(0, ball).total();
    ContactSteps<Rk4> steps(racket);
    for (int i = 0; i < 100; ++i) steps(i * 1e-3, ball, 1e-3);
    CAPTURE(speed);
    CHECK_FALSE(racket.through);  // it was let off
    // RK4 in pieces of omega0 dt = 1e-3; at the rim the force has a kink: order 2.
    CHECK(std::abs(racket.energy(0.1, ball).total() / before - 1) < 1e-5);
  }
}

TEST_CASE(
    "hard case: a floor faster than the step can see is refused, with the step that would do") {
  // 900 rad/s at dt = 1/240: 3.75 rad a step, and a stroboscope sees another, slower floor.
  const std::string fast =
      "06_oscillating_floor --headless --duration 1 --set amplitude=0.001 "
      "--set angular_frequency=900 ";
  for (const std::string method : {"explicit-euler", "semi-implicit-euler", "velocity-verlet",
                                   "rk4", "rk4-events", "flight-rk4"}) {
    const test::Outcome run = run_program(fast + "--dt 0.004166666666666667 --method " + method);
    CAPTURE(method);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(run.err.find("angular_frequency") != std::string::npos);
    CHECK(run.err.find("0.00175") != std::string::npos);  // pi/2 / 900
    CHECK(run_program(fast + "--dt 0.0005 --method " + method).code == 0);
  }
  // These two have no step: they do not look at it, and see the floor.
  std::vector<double> heights;
  for (const std::string method : {"exact", "reference"}) {
    for (const std::string dt : {"0.004166666666666667", "0.0005"}) {
      const test::Outcome run =
          run_program(fast + "--csv - --at 1 --method " + method + " --dt " + dt);
      CAPTURE(method);
      CAPTURE(run.err);
      REQUIRE(run.code == 0);
      double t = 0, floor = 0, y = 0;
      std::sscanf(run.out.c_str(), "t,floor,y,v\n%lf,%lf,%lf", &t, &floor, &y);
      CHECK(t == 1);
      heights.push_back(y);
    }
  }
  CHECK(heights[0] == heights[1]);
  CHECK(heights[2] == heights[3]);
  CHECK(std::abs(heights[2] - heights[0]) < 1e-10);  // reference's tolerance is 1e-12 a step
  // A floor that does not swing may have any frequency.
  CHECK(run_program("06_oscillating_floor --headless --duration 1 --set amplitude=0 "
                    "--set angular_frequency=900 --dt 0.004")
            .code == 0);
}
