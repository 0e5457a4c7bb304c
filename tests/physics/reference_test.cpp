// The method `reference`: its integrator's order, and its error and cost across bounces.

#include "physics/reference.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "03_damping/exact.hpp"
#include "physics/reference_values.hpp"
#include "run/scene_simulation.hpp"
#include "stages/methods.hpp"

using namespace bounce;

namespace {

using Run = SceneSimulation<Damping, DampingExact>;

Run run_of(double damping, const char* contact, double tolerance) {
  Run run;
  for (const Parameter& parameter : run.parameters()) {
    if (parameter.name == "damping") parameter.set(std::to_string(damping));
    if (parameter.name == "contact") parameter.set(contact);
  }
  run.restart();
  run.use_method(Method::reference);
  run.use_tolerance(tolerance);
  return run;
}

// x'' = -sin x - 0.3 x': not linear, so that all order conditions count, not only those of
// quadrature.
struct Pendulum {
  double acceleration(double /*t*/, const State<double>& state) const {
    return -std::sin(state.position) - 0.3 * state.velocity;
  }
};

State<double> swing(int steps) {
  DormandPrince<double> method;
  State<double> state{2, 0};
  for (int i = 0; i < steps; ++i) {
    method.start_at(Pendulum{}, 0, state);
    state = method.step(Pendulum{}, 0, 4.0 / steps);
  }
  return state;
}

}  // namespace

TEST_CASE("the integrator behind `reference` is of order 8") {
  const State<double> right = swing(1000);
  std::vector<double> dts, errors;
  for (int steps = 4; steps <= 20; ++steps) {  // below 1e-13 rounding counts
    dts.push_back(4.0 / steps);
    errors.push_back(std::abs(swing(steps).position - right.position));
  }
  const double order = test::fitted_slope(dts, errors);
  INFO("measured order ", order);
  CHECK(order > 7.5);
}

TEST_CASE("reference stays within 1e-11 m of the exact solution, with dampers and without") {
  for (const char* contact : {"slides", "push-only"}) {
    for (const double damping : {0.0, 5.0, 40.0, 150.0, 199.9, 450.0}) {
      Run run = run_of(damping, contact, 1e-12);
      for (int i = 1; i <= 50; ++i) {
        run.advance_to(0.1 * i);
        CAPTURE(contact);
        CAPTURE(damping);
        CAPTURE(run.time());
        CHECK(run.error()->position < 1e-11);
        CHECK(run.error()->velocity < 1e-10);
      }
    }
  }
}

TEST_CASE("the tolerance rules the error") {
  double before = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    Run run = run_of(5, "slides", tolerance);
    run.advance_to(5);
    const double error = run.error()->position;
    INFO("tolerance ", tolerance, ", error ", error);
    CHECK(error < 10 * tolerance);  // seven bounces, each of which doubles what it is given
    CHECK(error < before / 5);
    before = error;
  }
}

TEST_CASE("who looks at a reference run does not change it") {
  Run whole = run_of(5, "push-only", 1e-9), looked_at = whole;
  whole.advance_to(3);
  for (int i = 1; i <= 700; ++i) looked_at.advance_to(3.0 * i / 700);
  CHECK(whole.values() == looked_at.values());
}
