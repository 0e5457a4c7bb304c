// Methods whose steps are cut at touch and lift-off: their order, their cost, and that no event is
// missed.

#include "physics/events/located_events.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "07_tilted_plane/exact.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "random_numbers.hpp"
#include "run_with.hpp"
#include "stages/methods.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using test::set;

namespace {

using DampedRun = OneBallRun<Damping, DampingExact>;

DampedRun run_of(double damping, const char* contact, Method method, double dt) {
  return test::run_with<DampedRun>({{"damping", to_text(damping)}, {"contact", contact}}, method,
                                   dt);
}

double worst_error(DampedRun run, double t_end) {
  double worst = 0;
  for (int i = 1; i <= 50; ++i) {
    run.advance_to(t_end * i / 50);
    worst = std::max(worst, run.error()->position);
  }
  return worst;
}

/// By a fit over 20 time steps: where a touch falls within a step is chance, and two would flatter.
double order_of(Method method, double damping, const char* contact, double coarsest) {
  std::vector<double> dts, errors;
  for (int n = 0; n < 20; ++n) {
    const double dt = coarsest / std::pow(1.13, n);
    dts.push_back(dt);
    errors.push_back(worst_error(run_of(damping, contact, method, dt), 2.5));
  }
  return test::fitted_slope(dts, errors);
}

// What the mechanism does for any other method that carries nothing from step to step.
template <class Step>
double order_with_events(Step step, double damping) {
  std::vector<double> dts, errors;
  Damping scene;
  scene.damping = damping;
  EventDriven<DampingExact> exact(DampingExact(scene), 0, scene.start);
  const State<double> right = exact.at(1.0);
  for (int n = 0; n < 20; ++n) {
    const int steps = static_cast<int>(3000 * std::pow(1.13, n));
    LocatedEvents<DampingExact, double> located(DampingExact(scene), 0, scene.start);
    State<double> state = scene.start;
    for (int i = 0; i < steps; ++i) located(step, double(i) / steps, state, double(i + 1) / steps);
    dts.push_back(1.0 / steps);
    errors.push_back(std::abs(state.position - right.position));
  }
  return test::fitted_slope(dts, errors);
}

}  // namespace

TEST_CASE("with located events RK4 keeps its order 4 across bounces, without it falls to 1 or 2") {
  for (const char* contact : {"may-pull", "push-only"}) {
    for (const double damping : {0.0, 5.0, 40.0}) {
      CAPTURE(contact);
      CAPTURE(damping);
      for (const Method method : {methods::rk4_events, methods::flight_rk4}) {
        // From omega0 dt = 0.06 down to 0.006: coarser, errors of the next order still count (RK4's
        // error in the amplitude is of order 5); finer, the rounding of 1e5 steps does.
        const double order = order_of(method, damping, contact, 6e-4);
        INFO(name_of(method), ": measured order ", order);
        CHECK(order > 3.5);
      }
      const double without = order_of(methods::rk4, damping, contact, 2e-3);
      CHECK(without < (damping > 0 ? 1.5 : 2.4));
    }
  }
}

TEST_CASE("the mechanism serves any stepping method") {
  const auto semi = [](auto& law, double t, auto& x, double h) {
    semi_implicit_euler(law, t, x, h);
  };
  const auto verlet = [](auto& law, double t, auto& x, double h) {
    VelocityVerlet<double>{}(law, t, x, h);
  };
  CHECK(order_with_events(semi, 5) == doctest::Approx(1).epsilon(0.15));
  CHECK(order_with_events(verlet, 0) == doctest::Approx(2).epsilon(0.1));
  // The half-step damper keeps velocity Verlet at order 1 in a damped contact, cut or not.
  CHECK(order_with_events(verlet, 22) == doctest::Approx(1).epsilon(0.2));
}

TEST_CASE("flights by formula save their force evaluations and change nothing else") {
  DampedRun stepped = run_of(5, "may-pull", methods::rk4_events, 1e-4);
  DampedRun formula = run_of(5, "may-pull", methods::flight_rk4, 1e-4);
  stepped.advance_to(5);
  formula.advance_to(5);
  // 50000 steps of four evaluations, and a few for the cuts, at each of 7 bounces.
  CHECK(stepped.counted_force_evaluations() >= 200000);
  CHECK(stepped.counted_force_evaluations() < 200000 + 7 * 40);
  // Seven contacts of 0.0314 s each.
  CHECK(formula.counted_force_evaluations() ==
        doctest::Approx(7 * 0.0314 / 1e-4 * 4).epsilon(0.05));
  CHECK(std::abs(stepped.values()[0] - formula.values()[0]) < 1e-10);
}

TEST_CASE("the law of a phase is the scene's own law") {
  std::mt19937 random(3);
  const auto any = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 2000; ++i) {
    const ContactLaw law = i % 2 == 0 ? ContactLaw::may_pull : ContactLaw::push_only;
    const State<double> y{any(0, 0.2), any(-5, 5)};
    Damping line;
    line.damping = 40;
    line.contact = law;
    const DampingExact exact(line);
    // Forces are of size 1e3: a few roundings.
    CHECK(std::abs(exact.acceleration(exact.phase_at(y), 0, y) - line.acceleration(0, y)) < 2e-12);

    const State<Eigen::Vector3d> p{{any(-1, 1), y.position, any(-1, 1)},
                                   {any(-1, 1), y.velocity, 0}};
    ThreeDimensions space;
    space.contact = law;
    const ThreeDimensionsExact in_space(space);
    CHECK((in_space.acceleration(in_space.phase_at(p), 0, p) - space.acceleration(0, p)).norm() <
          2e-12);
    TiltedPlane tilted;
    tilted.contact = law;
    const TiltedPlaneExact on_plane(tilted);
    CHECK((on_plane.acceleration(on_plane.phase_at(p), 0, p) - tilted.acceleration(0, p)).norm() <
          2e-11);
  }
}

TEST_CASE("no event is missed, however large the step") {
  // A step as long as a whole contact: the error is what it is, but each bounce happens.
  for (const char* contact : {"may-pull", "push-only"}) {
    for (const double dt : {0.005, 0.02}) {
      DampedRun run = run_of(1, contact, methods::flight_rk4, dt);
      CAPTURE(contact);
      CAPTURE(dt);
      for (int i = 1; i <= 400; ++i) {
        run.advance_to(5.0 * i / 400);
        CHECK(run.values()[0] > 0);  // 0.1 m deep would be through the floor
        CHECK(run.values()[0] < 1.05);
      }
    }
  }
}

TEST_CASE("a located run that is cut, saved and resumed goes on as if nothing had been") {
  for (const Method method : {methods::rk4_events, methods::flight_rk4}) {
    DampedRun whole = run_of(5, "push-only", method, 1e-3), parts = whole;
    whole.advance_to(3);
    for (int i = 1; i <= 40; ++i) {
      parts.advance_to(i * 0.075);
      DampedRun again = run_of(5, "push-only", method, 1e-3);
      again.recall(parts.memory());
      parts = again;
    }
    // The cuts lie on whole steps; only the rounding of the times differs.
    CHECK(parts.values()[0] == doctest::Approx(whole.values()[0]).epsilon(1e-12));
  }
}

TEST_CASE("a ball that has come to rest is moved in whole steps") {
  // Over-damped (zeta = 2.5), and stable up to 5.8 ms. The bound from the touch at 4 m/s would cut
  // each step into four for ever, because the ball rests only 1 mm deep.
  for (const Method method : {methods::rk4_events, methods::flight_rk4}) {
    OneBallRun<Damping, DampingExact> run;
    set(run, "damping", "500");
    run.use_method(method);
    run.use_dt(5e-3);
    run.restart();
    run.advance_to(1);  // from 0.43 s on it touches
    const long long before = run.counted_force_evaluations();
    run.advance_to(11);
    CAPTURE(name_of(method));
    CHECK(run.counted_force_evaluations() - before == 4 * 2000);
  }
}
