#include "physics/methods/stepping_methods.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace bounce;

namespace {

// x'' + 2 beta x' + x = 0 with omega0 = 1: smooth, so that every method shows its own order.
struct Oscillator {
  double beta;
  double acceleration(double /*t*/, const State<double>& s) const {
    return -s.position - 2 * beta * s.velocity;
  }
};

// From x = 1 at rest: x(t) = exp(-beta t) (cos wt + beta/w sin wt).
State<double> exact(double beta, double t) {
  const double w = std::sqrt(1 - beta * beta), e = std::exp(-beta * t);
  return {e * (std::cos(w * t) + beta / w * std::sin(w * t)), -e * std::sin(w * t) / w};
}

template <class Step>
double error_after(double beta, double t_end, int steps, Step step) {
  const Oscillator scene{beta};
  State<double> state{1, 0};
  const double dt = t_end / steps;
  for (int i = 0; i < steps; ++i) step(scene, i * dt, state, dt);
  const State<double> right = exact(beta, t_end);
  return std::hypot(state.position - right.position, state.velocity - right.velocity);
}

/// The slope of log(error) against log(dt), by least squares over several dt: two alone can
/// flatter.
template <class Make>
double fitted_order(double beta, Make make) {
  std::vector<double> x, y;
  for (const int steps : {100, 140, 200, 280, 400, 560, 800}) {
    x.push_back(std::log(5.0 / steps));
    y.push_back(std::log(error_after(beta, 5, steps, make())));
  }
  double mx = 0, my = 0, sxy = 0, sxx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / 7, my += y[i] / 7;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxy += (x[i] - mx) * (y[i] - my);
    sxx += (x[i] - mx) * (x[i] - mx);
  }
  return sxy / sxx;
}

const auto explicit_step = [] {
  return [](auto& s, double t, auto& x, double dt) { explicit_euler(s, t, x, dt); };
};
const auto semi_implicit_step = [] {
  return [](auto& s, double t, auto& x, double dt) { semi_implicit_euler(s, t, x, dt); };
};
const auto verlet_step = [] { return VelocityVerlet<double>{}; };
const auto rk4_step = [] {
  return [](auto& s, double t, auto& x, double dt) { rk4(s, t, x, dt); };
};

}  // namespace

TEST_CASE("each method has its order on a smooth movement") {
  // A fit over dt = 0.006 to 0.05 deviates from the order by terms of relative size dt: 0.1 is
  // ample, and an order that dropped by one is far outside.
  for (const double beta : {0.0, 0.1}) {
    CAPTURE(beta);
    CHECK(fitted_order(beta, explicit_step) == doctest::Approx(1).epsilon(0.1));
    CHECK(fitted_order(beta, semi_implicit_step) == doctest::Approx(1).epsilon(0.1));
    CHECK(fitted_order(beta, rk4_step) == doctest::Approx(4).epsilon(0.03));
  }
  CHECK(fitted_order(0, verlet_step) == doctest::Approx(2).epsilon(0.05));
}

TEST_CASE("velocity Verlet with the half-step velocity loses an order to a damper") {
  CHECK(fitted_order(0.1, verlet_step) == doctest::Approx(1).epsilon(0.1));
}

TEST_CASE("on an undamped spring, explicit Euler grows by 1 + (omega0 dt)^2 in energy a step") {
  for (const double dt : {0.001, 0.03, 0.5}) {
    const Oscillator scene{0};
    State<double> state{0.3, -0.7};
    double energy = state.position * state.position + state.velocity * state.velocity;
    for (int i = 0; i < 20; ++i) {
      explicit_euler(scene, 0, state, dt);
      const double now = state.position * state.position + state.velocity * state.velocity;
      CAPTURE(dt);
      CHECK(now / energy == doctest::Approx(1 + dt * dt).epsilon(1e-14));  // a few roundings
      energy = now;
    }
  }
}

TEST_CASE("on an undamped spring, the symplectic methods conserve an energy of their own exactly") {
  // Semi-implicit Euler: v^2 + x^2 - dt x v. Velocity Verlet: v^2 + (1 - dt^2/4) x^2.
  // (Hairer, Lubich, Wanner, Geometric Numerical Integration, ch. IX.)
  for (const double dt : {0.01, 0.3, 1.9}) {
    const Oscillator scene{0};
    State<double> a{0.3, -0.7}, b = a;
    VelocityVerlet<double> verlet;
    const auto of_a = [&] {
      return a.velocity * a.velocity + a.position * a.position - dt * a.position * a.velocity;
    };
    const auto of_b = [&] {
      return b.velocity * b.velocity + (1 - dt * dt / 4) * b.position * b.position;
    };
    const double start_a = of_a(), start_b = of_b();
    for (int i = 0; i < 10000; ++i) {
      semi_implicit_euler(scene, 0, a, dt);
      verlet(scene, 0, b, dt);
    }
    CAPTURE(dt);
    // 1e4 steps of a few roundings each, adding up at worst in line: 1e4 x 1e-15; the form loses
    // 1/(1 - dt/2) = 20 in conditioning at dt = 1.9.
    CHECK(of_a() == doctest::Approx(start_a).epsilon(2e-10));
    CHECK(of_b() == doctest::Approx(start_b).epsilon(2e-10));
  }
}
