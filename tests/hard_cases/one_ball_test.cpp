// One ball, one floor: the cases that other simulators tell stories about.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "07_tilted_plane/exact.hpp"
#include "physics/events/event_driven.hpp"
#include "rounding.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/methods.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::epsilon;
using test::run_program;
using test::set;

namespace {

using Run3 = OneBallRun<Damping, DampingExact>;
using Run4 = OneBallRun<ThreeDimensions, ThreeDimensionsExact>;

const std::vector<Method> every_method{methods::explicit_euler, methods::semi_implicit_euler,
                                       methods::velocity_verlet, methods::rk4, methods::exact};

Damping undamped() {
  Damping scene;
  scene.damping = 0;
  return scene;
}

EventDriven<DampingExact> exact_of(const Damping& scene, double t = 0) {
  return {DampingExact(scene), t, scene.start};
}

void set(Simulation& run, const std::string& name, double value) {
  test::set(run, name, to_text(value));
}

double number_after(const std::string& text, const std::string& word) {
  return std::stod(text.substr(text.find(word) + word.size()));
}

}  // namespace

TEST_CASE("hard case: a stiff contact warns of a step of 1 ms, and --dt auto keeps the energy") {
  // omega0 = 12150 /s: a step of 1 ms is six times the limit, and the ball comes back much faster.
  const std::string stiff =
      "02_spring_floor --headless --duration 2 --set mass=0.021 "
      "--set stiffness=3.1e6 ";
  const test::Outcome naive = run_program(stiff);
  CAPTURE(naive.err);
  CHECK(naive.err.find("is too large") != std::string::npos);
  CHECK(number_after(naive.err, "energy_drift=") > 10);
  const test::Outcome taken = run_program(stiff + "--dt auto");
  CAPTURE(taken.err);
  // Each of some 5 contacts changes the speed by 0.00125 at most, and the energy by twice that.
  CHECK(std::abs(number_after(taken.err, "energy_drift=")) < 5 * 2 * 0.00125);
  CHECK(taken.err.find("warning") == std::string::npos);
}

TEST_CASE("hard case: a dust grain on a floor of 1e9 N/m: exact bounces it, steps are refused") {
  Damping scene = undamped();
  scene.mass = 1e-12;
  scene.stiffness = 1e9;
  EventDriven<DampingExact> walker = exact_of(scene);
  for (int bounce = 0; bounce < 1000; ++bounce) {
    walker.pass_event();
    walker.pass_event();
    // A mirror: the speed is taken over, and each flight's is a square root of it: one rounding.
    CHECK(std::abs(walker.state_at_last_event().velocity / std::sqrt(2 * 9.81 * 0.9) - 1) <
          (bounce + 2) * 4 * epsilon);
  }
  const test::Outcome steps =
      run_program("02_spring_floor --headless --dt auto --set mass=1e-12 --set stiffness=1e9");
  CHECK(steps.code == 2);
  CHECK(steps.err.find("at most 1e11") != std::string::npos);
}

TEST_CASE("hard case: a ball rests for 1e6 s and does not drift by a rounding") {
  for (const Method method :
       {methods::semi_implicit_euler, methods::velocity_verlet, methods::rk4, methods::exact}) {
    Run3 run;
    set(run, "stiffness", 100);  // omega0 = 10 /s, so that 1e7 steps of 0.1 s are stable
    set(run, "damping", 1);
    set(run, "position", 0.1 - 9.81 / 100);
    run.use_method(method);
    run.use_dt(0.1);
    run.restart();
    run.advance_to(1e6);
    CAPTURE(name_of(method));
    // Force balance is rounded to some 1e-15 N; the damper brings that to rest, at its own spacing.
    CHECK(std::abs(run.state().position - (0.1 - 9.81 / 100)) < 10 * epsilon * 0.1);
    CHECK(std::abs(run.state().velocity) < 100 * epsilon);
  }
}

TEST_CASE("hard case: the phase of a resting swing is right after 1e6 s") {
  Damping scene = undamped();
  const double sag = 9.81 / 1e4, swing = 5e-4;  // less than the sag: it never lifts off
  scene.start = {0.1 - sag + swing, 0};
  EventDriven<DampingExact> walker = exact_of(scene);
  CHECK(walker.next_event() == never);
  for (const double t : {1.0, 1e3, 1e6 + 0.123}) {
    const auto angle = 100.0L * static_cast<long double>(t);
    const double expected = 0.1 - sag + swing * static_cast<double>(std::cos(angle));
    CAPTURE(t);
    // w t is rounded twice: by its own spacing each time.
    CHECK(std::abs(walker.at(t).position - expected) < swing * 100 * t * 2 * epsilon + 1e-16);
  }
}

TEST_CASE("hard case: a drop from 1e-9 m keeps its energy for 1e5 bounces") {
  Damping scene = undamped();
  scene.start = {0.1 + 1e-9, 0};
  EventDriven<DampingExact> walker = exact_of(scene);
  walker.pass_event();
  // The height above the touch is what 0.1 + 1e-9 holds of it: 8 digits.
  const double height = scene.start.position - 0.1, speed = std::sqrt(2 * 9.81 * height);
  for (int i = 0; i < 100000; ++i) walker.pass_event(), walker.pass_event();
  CHECK(std::abs(-walker.state_at_last_event().velocity / speed - 1) < 1e5 * 2 * epsilon);
  CHECK(walker.last_event() > 1e5 * 0.03);  // each contact is about half a swing and more
}

TEST_CASE("hard case: a start deep in the floor, and with the centre below it, is a spring") {
  for (const double y : {0.05, 0.0, -0.3, -5.0}) {
    Damping scene = undamped();
    scene.start = {y, 0};
    EventDriven<DampingExact> walker = exact_of(scene);
    walker.pass_event();
    const double d = 0.1 - y, speed = std::sqrt(1e4 * d * d - 2 * 9.81 * d);  // energy
    CAPTURE(y);
    CHECK(std::abs(walker.state_at_last_event().velocity / speed - 1) < 1e-12);
    // And RK4 finds the same, to its order: (omega0 dt)^4 = 1e-8 in the contact.
    Run3 run;
    set(run, "damping", 0);
    set(run, "position", y);
    run.use_method(methods::rk4);
    run.use_dt(1e-4);
    run.restart();
    run.advance_to(0.1);
    CHECK(std::abs(run.energy().total() / (1e4 * d * d / 2 + 9.81 * y) - 1) < 1e-4);
  }
}

TEST_CASE("hard case: nothing happens at critical damping, nor within 1e-9 of it") {
  // c = 2 sqrt(k m) = 200. The movement depends smoothly on c: within a relative change delta of
  // the damper by less than delta times the largest term, v0 t.
  const auto at = [](double c, double t) {
    Damping scene;
    scene.damping = c;
    scene.start = {0.1, -3};
    return exact_of(scene).at(t);
  };
  for (const double t : {1e-4, 1e-3, 0.01, 0.03, 0.1}) {
    const State<double> critical = at(200, t);
    for (const double delta : {1e-6, 1e-9, 1e-12, 1e-15}) {
      for (const double sign : {-1.0, 1.0}) {
        const State<double> near = at(200 * (1 + sign * delta), t);
        CAPTURE(t);
        CAPTURE(delta);
        CHECK(std::abs(near.position - critical.position) <= 3 * 0.01 * delta + 4 * epsilon);
        CHECK(std::abs(near.velocity - critical.velocity) <= 3 * delta * 2 + 40 * epsilon);
      }
    }
    // By the textbook's formula for critical damping, with the sag: x = (x0 + (v0 + w x0) t) e^-wt.
    const double sag = 9.81e-4, w = 100;
    const double x = (sag + (-3 + w * sag) * t) * std::exp(-w * t);
    CHECK(std::abs(critical.position - (0.1 - sag + x)) < 1e-15);
  }
}

TEST_CASE("hard case: denormal velocities do no harm") {
  for (const Method method : every_method) {
    for (const double tiny : {5e-324, -5e-324, 1e-310}) {
      Run3 run, still;
      set(run, "velocity", tiny);
      for (Run3* one : {&run, &still}) {
        one->use_method(method);
        one->restart();
        one->advance_to(2);
      }
      CAPTURE(name_of(method));
      // It is lost in the first g dt. `exact` takes another formula for a ball that flies upwards:
      // a rounding of each of some ten phases, and the speeds after them.
      const double allowed = method == methods::exact ? 1e-13 : 0;
      CHECK(std::abs(run.state().position - still.state().position) <= allowed);
      CHECK(std::abs(run.state().velocity - still.state().velocity) <= 10 * allowed);
    }
  }
}

TEST_CASE("hard case: dt = 0 is refused, with the value and what is allowed") {
  for (const std::string dt : {"0", "-0", "1e-320", "-1e-3"}) {
    const test::Outcome run = run_program("03_damping --headless --dt " + dt);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(run.err.find("from 1e-15 to 1e+15") != std::string::npos);
  }
}

TEST_CASE("hard case: a step that divides neither frame nor duration ends at the same time") {
  for (const double dt : {0.3, 0.0007, 1.0 / 3, 0.001}) {
    for (const Method method : {methods::velocity_verlet, methods::rk4}) {
      Run3 run;
      set(run, "position", 100);  // in flight, where these two are exact
      run.use_method(method);
      run.use_dt(dt);
      run.restart();
      for (double frame = 1; frame <= 60; ++frame) run.advance_to(frame / 60);
      run.advance_to(1);
      CAPTURE(dt);
      CHECK(run.time() == 1);
      CHECK(std::abs(run.state().position - (100 - 9.81 / 2)) < 1e-12 * 100);
    }
  }
}

TEST_CASE("hard case: at 1e7 m the ball moves as it does at 0, to the spacing of doubles there") {
  const double far = 1e7, spacing = 1.862645149230957e-9;  // of doubles at 1e7
  for (const Method method : every_method) {
    Run4 here, there;
    set(there, "position", "1e7,1,-1e7");
    for (Run4* run : {&here, &there}) {
      run->use_method(method);
      run->use_dt(1e-3);
      run->restart();
    }
    for (double t = 0.25; t <= 10; t += 0.25) {  // about ten bounces
      here.advance_to(t), there.advance_to(t);
      const Vector3d gap = there.state().position - Vector3d(far, 0, -far) - here.state().position;
      CAPTURE(name_of(method));
      CAPTURE(t);
      CHECK(gap.y() == 0);  // the height does not know of it, to the bit
      // The others round to half a spacing at every step, exact only where it is looked at. A
      // hundredth for what the copy at 0 rounds.
      const double allowed = method == methods::exact ? 0.51 : 0.5 * t / 1e-3 + 1;
      CHECK(std::max(std::abs(gap.x()), std::abs(gap.z())) <= allowed * spacing);
    }
  }
}

TEST_CASE(
    "hard case: 1e7 m along a tilted plane exact is right to one spacing, bounce after bounce") {
  const double far = 1e7, spacing = 1.862645149230957e-9;
  for (const double tilt : {0.0, 0.1, 0.5}) {
    OneBallRun<TiltedPlane, TiltedPlaneExact> here, there;
    for (auto* run : {&here, &there}) {
      const std::string shift = run == &there ? "1e7" : "0";  // level, and so along the plane
      set(*run, "normal", to_text(tilt) + ",1,0");
      set(*run, "position", "0,1," + shift);
      set(*run, "velocity", "0.3,0,0.7");
      run->use_method(methods::exact);
      run->restart();
    }
    CAPTURE(tilt);
    for (double t = 0.25; t <= 10; t += 0.25) {
      here.advance_to(t), there.advance_to(t);
      const Vector3d gap = there.state().position - Vector3d(0, 0, far) - here.state().position;
      CAPTURE(t);
      CHECK(gap.x() == 0);
      CHECK(gap.y() == 0);
      CHECK(std::abs(gap.z()) <= 0.51 * spacing);
    }
  }
}

TEST_CASE("hard case: without a damper time can run backwards") {
  for (const Method method : {methods::exact, methods::velocity_verlet}) {
    Run3 run;
    set(run, "damping", 0);
    run.use_method(method);
    run.use_dt(1e-3);
    run.restart();
    run.advance_to(3);  // some seven contacts
    run.place({run.state().position, -run.state().velocity});
    run.advance_to(6);
    CAPTURE(name_of(method));
    // A speed of up to 4.2 m/s is rounded to half an epsilon of it, by `exact` some four times in
    // each of 30 phases, by a stepping method in each of 6000 steps: with either sign, so that the
    // sum goes with the root of their number, here with a reserve of 10. In flight such an error
    // grows into a distance, for up to 6 s.
    const double roundings = method == methods::exact ? 4 * 30 : 10 * std::sqrt(6000.0);
    const double speed_error = roundings * 4.2 * epsilon / 2;
    CHECK(std::abs(run.state().position - 1) < 6 * speed_error);  // 3e-13 m and 2e-12 m
    CHECK(std::abs(run.state().velocity) < speed_error);
  }
}

TEST_CASE("hard case: units scaled by powers of two change no bit") {
  const double L = 1024, M = 1.0 / 32, T = 8;
  for (const Method method : every_method) {
    Run3 run, scaled;
    const Damping s;
    set(scaled, "mass", s.mass * M);
    set(scaled, "gravity", s.gravity * L / (T * T));
    set(scaled, "radius", s.radius * L);
    set(scaled, "stiffness", s.stiffness * M / (T * T));
    set(scaled, "damping", s.damping * M / T);
    set(scaled, "position", s.start.position * L);
    run.use_method(method), scaled.use_method(method);
    run.use_dt(1e-3), scaled.use_dt(1e-3 * T);
    run.restart(), scaled.restart();
    for (double t = 0.125; t <= 4; t += 0.125) {
      run.advance_to(t), scaled.advance_to(t * T);
      CAPTURE(name_of(method));
      CAPTURE(t);
      CHECK(scaled.state().position == run.state().position * L);
      CHECK(scaled.state().velocity == run.state().velocity * L / T);
    }
  }
}
