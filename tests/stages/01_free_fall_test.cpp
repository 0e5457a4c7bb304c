#include <doctest/doctest.h>

#include <cmath>

#include "01_free_fall/exact.hpp"
#include "methods.hpp"
#include "physics/events/event_driven.hpp"

using namespace bounce;
using test::all_methods;
using test::run;

namespace {

constexpr double g = 9.81;

// Adding n numbers, each rounded once: an error of at most n/2 spacings of the largest sum.
double rounding(int steps, double largest) { return steps * 1.2e-16 * largest; }

}  // namespace

TEST_CASE("stage 1: the velocity is exact to rounding, whatever the method and the step") {
  for (const auto& method : all_methods<FreeFall>()) {
    for (const double dt : {0.1, 0.01, 1e-3, 1e-4}) {
      const FreeFall scene;
      const int steps = static_cast<int>(std::lround(1 / dt));
      const State<double> state = run(scene, method, dt, steps);
      INFO(method.name, " dt = ", dt, ": got v = ", state.velocity, ", expected ", -g * steps * dt,
           "; a constant force leaves no step error in v, so look at the velocity line");
      CHECK(std::abs(state.velocity + g * steps * dt) < rounding(3 * steps, g));
    }
  }
}

TEST_CASE("stage 1: the position error is +g t dt/2, -g t dt/2, and nothing for Verlet and RK4") {
  for (const auto& method : all_methods<FreeFall>()) {
    for (const double dt : {0.1, 0.03, 0.01, 1e-3, 1e-4}) {
      const FreeFall scene;
      const int steps = static_cast<int>(std::lround(1 / dt));
      const double t = steps * dt;
      const double expected = method.name == "explicit-euler"        ? g * t * dt / 2
                              : method.name == "semi-implicit-euler" ? -g * t * dt / 2
                                                                     : 0;
      const double error =
          run(scene, method, dt, steps).position - (scene.start.position - g * t * t / 2);
      INFO(method.name, " dt = ", dt, ": got an error of ", error, " m, expected ", expected,
           "; the wrong sign means position before velocity (or the other way round)");
      CHECK(std::abs(error - expected) < rounding(4 * steps, 10));
    }
  }
}

TEST_CASE("stage 1: halving dt halves the error of both Euler methods") {
  for (const auto& method : all_methods<FreeFall>()) {
    if (method.name != "explicit-euler" && method.name != "semi-implicit-euler") continue;
    std::vector<double> dts, errors;
    for (const int steps : {50, 100, 200, 400, 800}) {
      const FreeFall scene;
      dts.push_back(1.0 / steps);
      errors.push_back(std::abs(run(scene, method, 1.0 / steps, steps).position - (5 - g / 2)));
    }
    INFO(method.name);
    // The error is g t dt/2 with nothing behind it: the fit is exact up to rounding.
    CHECK(test::fitted_slope(dts, errors) == doctest::Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("stage 1: mass does not matter, to the bit for powers of two") {
  FreeFall light, heavy;
  for (const auto& method : all_methods<FreeFall>()) {
    for (const double factor : {1024.0, 1.0 / 4096}) {
      heavy.mass = factor;  // -m g / m rounds nothing when m is a power of two
      const State<double> a = run(light, method, 1e-3, 700), b = run(heavy, method, 1e-3, 700);
      INFO(method.name, " mass ", factor);
      CHECK(a.position == b.position);
      CHECK(a.velocity == b.velocity);
    }
    heavy.mass = 3.7;  // two more roundings a step
    CHECK(run(heavy, method, 1e-3, 700).position ==
          doctest::Approx(run(light, method, 1e-3, 700).position).epsilon(1e-12));
  }
}

TEST_CASE("stage 1: the slides' loop is semi-implicit Euler, to the bit") {
  const FreeFall scene;
  State<double> a = scene.start, b = scene.start;
  for (int i = 0; i < 1000; ++i) {
    fall_one_step(scene, i * 1e-3, a, 1e-3);
    semi_implicit_euler(scene, i * 1e-3, b, 1e-3);
  }
  CHECK(a.position == b.position);
  CHECK(a.velocity == b.velocity);
}

TEST_CASE("stage 1: the formula is y0 + v0 t - g t^2 / 2, thrown upwards too") {
  FreeFall scene;
  scene.start = {2, 3};
  EventDriven<FreeFallExact> exact(FreeFallExact(scene), 0, scene.start);
  for (const double t : {0.0, 0.1, 1.0, 10.0}) {
    CHECK(exact.at(t).position == doctest::Approx(2 + 3 * t - g * t * t / 2).epsilon(1e-15));
    CHECK(exact.at(t).velocity == doctest::Approx(3 - g * t).epsilon(1e-15));
  }
}
