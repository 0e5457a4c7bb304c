#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "03_damping/exact.hpp"
#include "methods.hpp"
#include "physics/events/event_driven.hpp"

using namespace bounce;
using test::all_methods;

namespace {

Damping ball(double damping, ContactLaw law) {
  Damping scene;
  scene.damping = damping;
  scene.contact = law;
  return scene;
}

/// Speed after the first contact / speed before it, by stepping. Without gravity the speeds do not
/// change in flight, so that it does not matter when they are read.
template <class Step>
double stepped_restitution(Damping scene, Step step, double dt) {
  scene.gravity = 0;
  scene.start = {scene.radius + 0.01, -1};
  State<double> state = scene.start;
  bool touched = false;
  for (int i = 0; i < 10000000; ++i) {
    step(scene, 0, state, dt);
    if (state.position < scene.radius) touched = true;
    if (touched && state.position >= scene.radius) return state.velocity;
  }
  return 0;
}

}  // namespace

TEST_CASE("stage 3: the damper brakes both ways, and only in the floor") {
  const Damping scene = ball(5, ContactLaw::may_pull);
  Damping undamped = ball(0, ContactLaw::may_pull);
  for (const double v : {-3.0, 2.0}) {
    INFO("v = ", v, ": the wrong sign drives the ball instead of braking it");
    CHECK(scene.force(0, {0.05, v}) - undamped.force(0, {0.05, v}) ==
          doctest::Approx(-5 * v).epsilon(1e-12));
    INFO("a damper outside the contact is air");
    CHECK(scene.force(0, {0.5, v}) == undamped.force(0, {0.5, v}));
  }
}

TEST_CASE("stage 3: restitution against damping, both laws, several steps, against the formulas") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const double zeta : {0.05, 0.2, 0.5, 0.9}) {
      const Damping scene = ball(200 * zeta, law);
      const double e = restitution({scene.stiffness, scene.damping, law}, scene.mass);
      for (const double dt : {3.1e-5, 1.3e-5, 0.7e-5}) {
        const double got = stepped_restitution(
            scene, [](auto& s, double t, auto& x, double h) { semi_implicit_euler(s, t, x, h); },
            dt);
        INFO("zeta = ", zeta, " dt = ", dt, ": got e = ", got, ", expected ", e);
        // First order: touch and lift-off are seen up to a step late, and the damper's force, c v,
        // jumps there: a relative error of 2 zeta omega0 dt each, plus omega0 dt / 2 of the method.
        CHECK(std::abs(got - e) < (0.5 + 4 * zeta) * 100 * dt);
      }
    }
  }
}

TEST_CASE("stage 3: without located events every method is of first order at a damped touch") {
  const Damping scene = ball(22, ContactLaw::may_pull);
  for (const auto& method : all_methods<Damping>()) {
    std::vector<double> dts, errors;
    EventDriven<DampingExact> exact(DampingExact(scene), 0, scene.start);
    const State<double> right = exact.at(1.0);
    for (int n = 0; n < 25; ++n) {
      const int steps = static_cast<int>(2000 * std::pow(1.2, n));
      const State<double> state = test::run(scene, method, 1.0 / steps, steps);
      dts.push_back(1.0 / steps);
      // A lucky dt can land on the touch by chance: the floor keeps it out of the fit.
      errors.push_back(std::max(1e-9, std::abs(state.position - right.position)));
    }
    const double order = test::fitted_slope(dts, errors);
    INFO(method.name, ": measured order ", order);
    // Where the touch falls within a step is a matter of chance, which scatters the fit by about
    // 0.25.
    CHECK(order > 0.6);
    CHECK(order < 1.45);
  }
}

TEST_CASE("stage 3: three regimes: it bounces, or it creeps") {
  for (const double zeta : {0.2, 0.9, 1.0, 2.5}) {
    const Damping scene = ball(200 * zeta, ContactLaw::may_pull);
    EventDriven<DampingExact> exact(DampingExact(scene), 0, scene.start);
    exact.pass_event();  // touch
    CAPTURE(zeta);
    // Close to critical the swing back is smaller than the sag m g / k: it stays down already at
    // 0.9.
    CHECK((exact.next_event() < never) == (zeta < 0.5));
  }
}

TEST_CASE("stage 3: the first height against the damping, as the demo promises") {
  struct Row {
    double damping, height;
  };
  // Heights from semi-implicit Euler with dt = 1e-6, right to 1e-4.
  for (const Row& row : {Row{5, .8653}, Row{18, .6000}, Row{43, .3119}, Row{100, .1162}}) {
    const Damping scene = ball(row.damping, ContactLaw::may_pull);
    EventDriven<DampingExact> exact(DampingExact(scene), 0, scene.start);
    exact.pass_event();
    exact.pass_event();
    const State<double> out = exact.state_at_last_event();
    CAPTURE(row.damping);
    CHECK(std::abs(out.position + out.velocity * out.velocity / (2 * 9.81) - row.height) < 1e-4);
  }
  // At 200 (critical) the slides' contact keeps the ball, the push-only contact lets it hop to
  // 0.1037 m.
  const Damping kept = ball(200, ContactLaw::may_pull);
  EventDriven<DampingExact> may_pull(DampingExact(kept), 0, kept.start);
  may_pull.pass_event();
  CHECK(may_pull.next_event() == never);
  const Damping hops = ball(200, ContactLaw::push_only);
  EventDriven<DampingExact> push(DampingExact(hops), 0, hops.start);
  while (push.phase() != Phase::flight || push.last_event() == 0) push.pass_event();
  const State<double> out = push.state_at_last_event();
  CHECK(std::abs(out.position + out.velocity * out.velocity / (2 * 9.81) - 0.1037) < 1e-4);
}

TEST_CASE("stage 3: the slides' contact pulls just before lift-off, push-only never does") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    const Damping scene = ball(43, law);
    State<double> state = scene.start;
    double smallest = 0;
    for (int i = 0; i < 100000; ++i) {
      semi_implicit_euler(scene, 0, state, 1e-5);
      smallest = std::min(smallest, scene.force(0, state) + scene.mass * scene.gravity);
    }
    CAPTURE(int(law));
    if (law == ContactLaw::may_pull) {
      // At lift-off the spring is slack and the damper alone acts: -c v, with v of about e x 4.2
      // m/s.
      CHECK(smallest < -43 * 1.5);
      CHECK(smallest > -43 * 4.2);
    } else {
      CHECK(smallest > -1e-12);  // (-m g + 0) + m g
    }
  }
}

TEST_CASE(
    "stage 3: every method comes to rest at r - m g / k; so that proves nothing about accuracy") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const auto& method : all_methods<Damping>()) {
      for (const double dt : {1e-3, 2e-4}) {
        Damping scene = ball(60, law);
        const State<double> state = test::run(scene, method, dt, static_cast<int>(6 / dt));
        INFO(method.name, " dt = ", dt);
        CHECK(state.position == doctest::Approx(0.1 - 9.81 / 1e4).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("stage 3: without damping it is stage 2, to the bit") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    const Damping scene = ball(0, law);
    const struct {
      double mass = 1, gravity = 9.81, radius = 0.1, stiffness = 1e4;
      double acceleration(double, const State<double>& s) const {
        double force = -mass * gravity;
        if (s.position < radius) force += stiffness * (radius - s.position);
        return force / mass;
      }
    } bare;
    State<double> a{1, 0}, b = a;
    for (int i = 0; i < 20000; ++i) {
      semi_implicit_euler(scene, 0, a, 1e-3);
      semi_implicit_euler(bare, 0, b, 1e-3);
    }
    CHECK(a.position == b.position);
    CHECK(a.velocity == b.velocity);
  }
}
