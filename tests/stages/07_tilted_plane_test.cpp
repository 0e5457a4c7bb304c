#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "rounding.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::epsilon;
using test::run_with;
using test::text;
using test::Values;

namespace {

using Run3 = OneBallRun<Damping, DampingExact>;
using Run4 = OneBallRun<ThreeDimensions, ThreeDimensionsExact>;
using Run7 = OneBallRun<TiltedPlane, TiltedPlaneExact>;

constexpr double g = 9.81;
const std::vector<Method> every_method{methods::explicit_euler, methods::semi_implicit_euler,
                                       methods::velocity_verlet, methods::rk4, methods::exact};

/// Unit normals: level, tilted along x, along both, steep, and a wall.
const std::vector<Vector3d> normals{
    {0, 1, 0}, {0.6, 0.8, 0}, {2.0 / 7, 6.0 / 7, -3.0 / 7}, {0.96, 0.28, 0}, {1, 0, 0}};

}  // namespace

TEST_CASE("stage 7: without gravity and damper the plane is a mirror") {
  // v' = v - 2 (n . v) n. In the contact semi-implicit Euler conserves v^2 + w^2 x^2 - dt w^2 x v,
  // with w = omega0. Its first overlap is x = f v dt with f from 0 to 1: the conserved form then
  // differs from v^2 by (w dt)^2 v^2 (f - f^2), at most a quarter of (w dt v)^2, and likewise at
  // the way out with the other sign. So v^2 comes back within a quarter of (w dt)^2 and v within
  // an eighth. Velocity Verlet is the same map seen from half step to half step, RK4 is better.
  // The velocity along the plane only rounds: n steps, half an epsilon each, in three components.
  const Vector3d velocity(1.3, -2.5, 0.7);
  const double omega0 = 100;  // sqrt(1e4 N/m / 1 kg)
  for (const Vector3d& n : normals) {
    const Vector3d before = n.dot(velocity) < 0 ? velocity : Vector3d(-velocity);
    const Vector3d mirrored = before - 2 * n.dot(before) * n;
    for (const Method method :
         {methods::semi_implicit_euler, methods::velocity_verlet, methods::rk4, methods::exact}) {
      for (const double dt : {1e-3, 1e-4, 1e-5}) {
        Run7 run = run_with<Run7>({{"gravity", "0"},
                                   {"damping", "0"},
                                   {"normal", text(n)},
                                   {"position", text(0.3 * n)},
                                   {"velocity", text(before)}},
                                  method, dt);
        run.advance_to(1);
        const Vector3d miss = run.state().velocity - mirrored;
        const bool exact = method == methods::exact;
        const double rounding = exact ? 20 * epsilon : 2 / dt * epsilon;
        const double normal_tolerance =
            exact ? rounding : 0.1251 * omega0 * dt * omega0 * dt * std::abs(n.dot(before));
        const std::string name = name_of(method), normal = text(n);
        CAPTURE(name);
        CAPTURE(normal);
        CAPTURE(dt);
        CHECK(std::abs(n.dot(miss)) <= normal_tolerance + rounding * 3);
        CHECK((miss - n.dot(miss) * n).norm() <= rounding * 3);
      }
    }
  }
}

TEST_CASE("stage 7: across the plane it is stage 3 with gravity's normal component") {
  for (const Vector3d& n : normals) {
    for (const char* contact : {"may-pull", "push-only"}) {
      for (const Method method : every_method) {
        for (const double dt : {1e-3, 1e-4}) {
          Run3 line = run_with<Run3>({{"gravity", to_text(g * n.y())},
                                      {"contact", contact},
                                      {"position", "0.7"},
                                      {"velocity", "-0.4"}},
                                     method, dt);
          const Vector3d sideways = Vector3d(0.3, 0.1, -0.2) - n.dot(Vector3d(0.3, 0.1, -0.2)) * n;
          Run7 space = run_with<Run7>({{"normal", text(n)},
                                       {"contact", contact},
                                       {"position", text(0.7 * n)},
                                       {"velocity", text(sideways - 0.4 * n)}},
                                      method, dt);
          for (double t = 0.25; t <= 2; t += 0.25) {
            line.advance_to(t);
            space.advance_to(t);
            // The distance is made of coordinates below L = 21 m and rounds like them, in each of
            // N steps; an error of the velocity, below 20 m/s, counts for the time t after it.
            const double N = method == methods::exact ? 50 : t / dt;
            const double tolerance = 3 * N * epsilon * 21 * (1 + t);
            const double distance = n.dot(space.state().position);
            const std::string name = name_of(method), normal = text(n);
            CAPTURE(name);
            CAPTURE(normal);
            CAPTURE(contact);
            CAPTURE(dt);
            CAPTURE(t);
            CHECK(std::abs(distance - line.state().position) <= tolerance);
          }
        }
      }
    }
  }
}

TEST_CASE("stage 7: a ball at rest on the slope slides down at g sin(angle)") {
  // It starts where the spring carries the weight's normal part, k d = m g cos(angle). With uniform
  // acceleration a the methods err as in free fall: +a t dt / 2 for explicit Euler, -a t dt / 2
  // for semi-implicit Euler in the distance covered. Damping 50 N s/m keeps explicit Euler stable.
  const double k = 1e4, r = 0.1;
  for (const double degrees : {1.0, 10.0, 30.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vector3d n(std::sin(angle), std::cos(angle), 0);
    const Vector3d downhill(std::cos(angle), -std::sin(angle), 0);
    const double a = g * std::sin(angle);
    const Vector3d start = (r - g * std::cos(angle) / k) * n;
    for (const Method method : every_method) {
      for (const double dt : {1e-3, 1e-4}) {
        Run7 run = run_with<Run7>({{"normal", text(n)},
                                   {"damping", "50"},
                                   {"position", text(start)},
                                   {"velocity", "0,0,0"}},
                                  method, dt);
        for (const double t : {0.5, 1.0, 2.0}) {
          run.advance_to(t);
          const double error_of_method = method == methods::explicit_euler        ? -a * t * dt / 2
                                         : method == methods::semi_implicit_euler ? a * t * dt / 2
                                                                                  : 0;
          const Vector3d expected = start + (a * t * t / 2 + error_of_method) * downhill;
          const double N = method == methods::exact ? 20 : t / dt;
          const double tolerance = 3 * N * epsilon * 20 * (1 + t);  // positions below 20 m
          const Vector3d miss = run.state().position - expected;
          const std::string name = name_of(method);
          CAPTURE(name);
          CAPTURE(degrees);
          CAPTURE(dt);
          CAPTURE(t);
          CHECK(miss.norm() <= tolerance);
          CHECK((run.state().velocity - a * t * downhill).norm() <= tolerance);
        }
      }
    }
  }
}

TEST_CASE("stage 7: only the direction of the normal counts") {
  // a x + b y + c z + d = 0 and the same equation times a factor are one plane.
  const Vector3d normal(0.3, 1, -0.2);
  const double offset = 0.37;
  const auto end_of_run = [&](double factor, Method method, double dt) {
    Run7 run = run_with<Run7>({{"normal", text(factor * normal)},
                               {"offset", to_text(factor * offset)},
                               {"velocity", "0.2,0,0.1"}},
                              method, dt);
    run.advance_to(2);
    return run.state();
  };
  for (const Method method : every_method) {
    for (const double dt : {1e-3, 1e-4}) {
      const State<Vector3d> one = end_of_run(1, method, dt);
      const std::string name = name_of(method);
      CAPTURE(name);
      CAPTURE(dt);
      for (const double factor : {0.25, 2.0, 1024.0}) {  // exact in binary: the same to the bit
        CAPTURE(factor);
        CHECK(end_of_run(factor, method, dt).position == one.position);
      }
      for (const double factor : {1e-12, 0.1, 3.0, 7e9}) {
        // The unit normal then differs in its last bit: as if the plane were turned by an epsilon,
        // which after N roundings in positions below 10 m is no more than they are.
        const double N = method == methods::exact ? 50 : 2 / dt;
        const double miss = (end_of_run(factor, method, dt).position - one.position).norm();
        CAPTURE(factor);
        CHECK(miss <= 3 * N * epsilon * 10 * (1 + 2));
      }
    }
  }
}

TEST_CASE("stage 7: a plane's equation is scaled as a whole") {
  const Plane plane = Plane::from_equation({0, 2, 0}, -3);  // 2 y - 3 = 0: y = 1.5
  CHECK(plane.normal == Vector3d(0, 1, 0));
  CHECK(plane.distance({7, 1.5, -2}) == 0);
  CHECK(plane.distance({7, 2.5, -2}) == 1);
  CHECK(plane.foot({7, 2.5, -2}) == Vector3d(7, 1.5, -2));
  // Lengths whose squares overflow or vanish.
  for (const double size : {1e-320, 1e-200, 1e200, 1e308}) {
    CAPTURE(size);
    CHECK((Plane::from_equation({size, size, 0}, 0).normal - Vector3d(1, 1, 0) / std::sqrt(2))
              .norm() <= 2 * epsilon);
  }
}

TEST_CASE("stage 7: a level plane through 0 is stage 4, to the bit") {
  for (const char* normal : {"0,1,0", "0,7,0", "0,1e-9,0"}) {
    for (const char* contact : {"may-pull", "push-only"}) {
      for (const Method method : every_method) {
        for (const double dt : {1e-2, 1e-3, 1e-4}) {
          const Values shared{
              {"position", "0.1,1,-0.3"}, {"velocity", "1,0.2,0.5"}, {"contact", contact}};
          Values tilted = shared;
          tilted.push_back({"normal", normal});
          Run4 level = run_with<Run4>(shared, method, dt);
          Run7 plane = run_with<Run7>(tilted, method, dt);
          for (double t = 0.2; t <= 3; t += 0.2) {
            level.advance_to(t);
            plane.advance_to(t);
            const std::string name = name_of(method);
            CAPTURE(name);
            CAPTURE(normal);
            CAPTURE(contact);
            CAPTURE(dt);
            CAPTURE(t);
            REQUIRE(plane.state().position == level.state().position);
            REQUIRE(plane.state().velocity == level.state().velocity);
          }
        }
      }
    }
  }
}

TEST_CASE("stage 7: hops on a slope grow like 1 : 2 : 3 : 4, and the beat does not change") {
  // A ball that falls by h reaches v = sqrt(2 g h). Without loss it flies for 2 v / g between two
  // touches: normal velocity and gravity's normal part both carry cos(angle), which cancels. The
  // contact takes (pi + 2 atan(g / (v omega0))) / omega0: half a swing, and a little more because
  // it swings around the rest height. Both together are the beat T. Along the slope the ball is
  // uniformly accelerated by g sin(angle) all the time, which gives the hops; for a hard contact
  // (T = 2 v / g) they are 8 h sin(angle) times 1, 2, 3, 4.
  const double h = 0.5, k = 1e6, r = 0.1;
  const double v = std::sqrt(2 * g * h), omega0 = std::sqrt(k);
  const double beat = 2 * v / g + (std::numbers::pi + 2 * std::atan(g / (v * omega0))) / omega0;
  for (const double degrees : {5.0, 10.0, 20.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vector3d n(std::tan(angle), 1, 0);
    Run7 run = run_with<Run7>({{"normal", text(n)},
                               {"damping", "0"},
                               {"stiffness", "1e6"},
                               {"position", text({0, h + r / std::cos(angle), 0})}},
                              methods::exact);
    std::vector<double> times, places;  // of the touches, along the slope
    while (times.size() < 5) {
      run.advance_to(run.next_event());
      if (run.state().velocity.dot(n) > 0) continue;  // that was a lift-off
      times.push_back(run.time());
      places.push_back(run.state().position.x() * std::cos(angle) -
                       run.state().position.y() * std::sin(angle));
    }
    for (std::size_t hop = 1; hop < 5; ++hop) {
      const double length = places[hop] - places[hop - 1];
      const double expected =
          std::sin(angle) * (v * beat + g * beat * beat * (static_cast<double>(hop) - 0.5));
      CAPTURE(degrees);
      CAPTURE(hop);
      // Two events a hop, a few operations each, with coordinates below 10 m; the time of a
      // lift-off is found to a few epsilon of the contact, and moves a place by v times that.
      CHECK(std::abs(times[hop] - times[hop - 1] - beat) <= 100 * epsilon);
      CHECK(std::abs(length - expected) <= 100 * epsilon * 10);
    }
  }
}

TEST_CASE("stage 7: a plane may hang over the ball") {
  // A ceiling at y = 1: -y + 1 = 0. Gravity pulls the ball away from it. Against RK4 with a small
  // step; in a damped contact its error is of order one: the force jumps by c v at the touch, so
  // that one step changes the velocity by at most c v dt / m, and the place by that times t.
  for (const double c : {0.0, 5.0, 500.0}) {  // elastic, under-damped, over-damped
    for (const char* contact : {"may-pull", "push-only"}) {
      for (const char* normal : {"0,-1,0", "0.6,-0.8,0"}) {
        const Values settings{{"normal", normal},        {"offset", "1"},
                              {"damping", to_text(c)},   {"contact", contact},
                              {"position", "0.2,0.1,0"}, {"velocity", "0.1,5,0"}};
        const double dt = 1e-6;
        Run7 exact = run_with<Run7>(settings, methods::exact);
        Run7 steps = run_with<Run7>(settings, methods::rk4, dt);
        for (const double t : {0.1, 0.2, 0.5}) {
          exact.advance_to(t);
          steps.advance_to(t);
          CAPTURE(c);
          CAPTURE(contact);
          CAPTURE(normal);
          CAPTURE(t);
          CHECK((exact.state().position - steps.state().position).norm() <=
                (c * 5 + 1e-3) * dt * (1 + t));
        }
        CHECK(exact.next_event() == never);  // it came down and never returns
      }
    }
  }
}

TEST_CASE("stage 7: what is no plane is refused") {
  struct Bad {
    const char *setting, *allowed;
  };
  for (const Bad& bad : {Bad{"normal=0,0,0", "not all of them 0"},
                         Bad{"normal=-0,0,0", "not all of them 0"}, Bad{"normal=1,2", "3 numbers"},
                         Bad{"normal=up", "3 numbers"}, Bad{"normal=0,inf,0", "3 numbers"},
                         Bad{"offset=nan", "a number from"}, Bad{"offset=1,2", "a number from"}}) {
    const test::Outcome outcome =
        test::run_program(std::string("07_tilted_plane --headless --set ") + bad.setting);
    CAPTURE(bad.setting);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(bad.allowed) != std::string::npos);
  }
  CHECK(test::run_program("07_tilted_plane --headless --set normal=0,1e-15,0").code == 0);
}
