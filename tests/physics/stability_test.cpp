#include "physics/stability.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "physics/methods/stepping_methods.hpp"

using namespace bounce;

namespace {

struct Contact {  // the linear contact, omega0 = 1
  double zeta;
  double acceleration(double /*t*/, const State<double>& s) const {
    return -s.position - 2 * zeta * s.velocity;
  }
};

/// Does a small disturbance grow? By growth alone, without knowing the method's matrix.
template <class Step>
bool grows(double zeta, double dt, Step step) {
  const Contact scene{zeta};
  State<double> state{1, 0.5};
  for (int i = 0; i < 20000; ++i) {
    step(scene, 0, state, dt);
    if (!(std::abs(state.position) + std::abs(state.velocity) < 1e12)) return true;
  }
  return std::abs(state.position) + std::abs(state.velocity) > 1e3;
}

/// The largest step that does not grow, by bisection.
template <class Make>
double measured_limit(double zeta, Make make) {
  double stable = 1e-3, unstable = 6;
  while (unstable - stable > 1e-4) {
    const double middle = (stable + unstable) / 2;
    (grows(zeta, middle, make()) ? unstable : stable) = middle;
  }
  return stable;
}

const auto semi_implicit_step = [] {
  return [](auto& s, double t, auto& x, double dt) { semi_implicit_euler(s, t, x, dt); };
};
const auto explicit_step = [] {
  return [](auto& s, double t, auto& x, double dt) { explicit_euler(s, t, x, dt); };
};
const auto verlet_step = [] { return VelocityVerlet<double>{}; };
const auto rk4_step = [] {
  return [](auto& s, double t, auto& x, double dt) { rk4(s, t, x, dt); };
};

// A growth of 1e3 in 20000 steps shows a multiplier of 1 + 0.00035; in dt that is less than 0.003.
constexpr double resolution = 0.003;

}  // namespace

TEST_CASE("the slides' loop is stable for omega0 dt < 2 (sqrt(1 + zeta^2) - zeta)") {
  CHECK(semi_implicit_euler_limit(0) == 2);
  CHECK(semi_implicit_euler_limit(0.1) == doctest::Approx(1.810).epsilon(1e-4));
  CHECK(semi_implicit_euler_limit(0.5) == doctest::Approx(1.236).epsilon(1e-4));
  CHECK(semi_implicit_euler_limit(1) == doctest::Approx(0.828).epsilon(1e-3));
  CHECK(semi_implicit_euler_limit(2.31) == doctest::Approx(0.414).epsilon(1e-3));
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.31}) {
    CAPTURE(zeta);
    const double limit = semi_implicit_euler_limit(zeta);
    CHECK(limit == doctest::Approx(2 * (std::sqrt(1 + zeta * zeta) - zeta)).epsilon(1e-14));
    CHECK(std::abs(measured_limit(zeta, semi_implicit_step) - limit) < resolution);
    CHECK(std::abs(measured_limit(zeta, verlet_step) - limit) < resolution);
  }
}

TEST_CASE("explicit Euler is stable up to 2 zeta, and so never without a damper") {
  CHECK(explicit_euler_limit(0) == 0);
  for (const double zeta : {0.3, 0.8, 1.0, 2.0}) {
    CAPTURE(zeta);
    CHECK(std::abs(measured_limit(zeta, explicit_step) - explicit_euler_limit(zeta)) < resolution);
  }
  CHECK(grows(0, 0.1, explicit_step()));
}

TEST_CASE("Runge-Kutta is stable up to 2 sqrt(2) without a damper") {
  CHECK(rk4_limit(0) == doctest::Approx(2 * std::sqrt(2.0)).epsilon(1e-6));
  for (const double zeta : {0.0, 0.05, 0.3, 0.7, 1.0, 2.0}) {
    CAPTURE(zeta);
    CHECK(std::abs(measured_limit(zeta, rk4_step) - rk4_limit(zeta)) < resolution);
  }
}

TEST_CASE(
    "stable is not accurate: the restitution of one undamped bounce depends on the phase of "
    "entry") {
  struct Row {
    double omega0_dt, lowest, highest;
  };
  // Without gravity, from v = -1 at every phase of the step grid (2000 of them).
  for (const Row& row : {Row{0.1, 0.9988, 1.0012}, Row{0.5, 0.978, 1.022}, Row{1.9, 0.39, 2.61}}) {
    double lowest = 9, highest = 0;
    for (int phase = 0; phase < 2000; ++phase) {
      struct Wall {
        double acceleration(double, const State<double>& s) const {
          return s.position < 0 ? -s.position : 0;
        }
      };
      const double dt = row.omega0_dt;
      State<double> state{(phase + 0.5) / 2000 * dt, -1};
      do semi_implicit_euler(Wall{}, 0, state, dt);
      while (state.position < 0 || state.velocity < 0);
      lowest = std::min(lowest, state.velocity);
      highest = std::max(highest, state.velocity);
    }
    CAPTURE(row.omega0_dt);
    // The table is rounded to its last digit.
    const double digit = row.omega0_dt < 0.2 ? 1e-4 : row.omega0_dt < 1 ? 1e-3 : 2e-2;
    CHECK(std::abs(lowest - row.lowest) < digit);
    CHECK(std::abs(highest - row.highest) < digit);
  }
}

TEST_CASE("the comfortable step is a twentieth of the slides' loop's limit") {
  CHECK(comfortable_step(100, 0) == doctest::Approx(1e-3).epsilon(1e-14));
  CHECK(comfortable_step(100, 1) == doctest::Approx(4.1421e-4).epsilon(1e-4));
}
