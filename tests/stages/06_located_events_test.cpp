// Stage 6 without a formula for the contact: steps that are cut at the events, and `reference`. The
// oracle is `exact`, which is tested against plain RK4 in 06_oscillating_floor_test.cpp.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "06_oscillating_floor/exact/exact.hpp"
#include "methods.hpp"
#include "random_numbers.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using test::set;

namespace {

using Exact = EventDriven<OscillatingFloorExact>;
using HighOrder = Reference<OneBallContacts<OscillatingFloorExact, double>, double>;
using Located = LocatedEvents<OscillatingFloorExact, double>;
using FloorRun = OneBallRun<OscillatingFloor, OscillatingFloorExact>;

constexpr auto rk4_step = [](auto& law, double t, State<double>& state, double h) {
  rk4(law, t, state, h);
};

HighOrder reference_of(const OscillatingFloor& scene, double t = 0) {
  const OneBallContacts<OscillatingFloorExact, double> contacts(OscillatingFloorExact(scene), t,
                                                                scene.start);
  return {contacts, t, scene.start, 1e-12};
}

State<double> at(HighOrder& run, double t) {
  run.reach(t, 100000000);
  return run.at(t);
}

class Dice {
 public:
  explicit Dice(unsigned long long seed) : random_(seed) {}
  double between(double low, double high) { return test::uniform(random_, low, high); }
  double between_powers(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }

  /// All laws, without damper and with one of every strength, floors slow and fast against the
  /// contact, from far too gentle to wild.
  OscillatingFloor scene(int n) {
    OscillatingFloor scene;
    scene.floor_law = static_cast<FloorLaw>(n % 3);
    scene.contact = n / 3 % 2 == 0 ? ContactLaw::may_pull : ContactLaw::push_only;
    const double zetas[] = {0, between(0, 0.3), between(0.3, 2), between_powers(2, 50)};
    scene.mass = between_powers(0.05, 8);
    const double omega0 = between_powers(30, 1000);
    scene.stiffness = scene.mass * omega0 * omega0;
    scene.damping = 2 * zetas[n / 6 % 4] * omega0 * scene.mass;
    scene.angular_frequency = between_powers(1, 200);
    scene.amplitude = 9.81 / std::pow(scene.angular_frequency, 2) * between_powers(0.1, 4.5);
    scene.phase = between(0, 2 * std::numbers::pi);
    scene.floor_velocity = n % 7 == 0 ? between(-0.3, 0.3) : 0;
    const double height = n % 5 == 0 ? between(-0.002, 0) : between(0, 0.3);
    scene.start = {scene.radius + scene.floor_height(0) + height, between(-1, 1)};
    return scene;
  }

 private:
  std::mt19937_64 random_;
};

/// How much a later position differs for a start that differs by 1; at least 1. Infinite where it
/// cannot be told.
class Sensitivity {
 public:
  explicit Sensitivity(const OscillatingFloor& scene)
      : higher_(twin(scene, {off, 0})), faster_(twin(scene, {0, off})) {}
  double at(double t, double position) {
    try {
      for (Exact* twin : {&higher_, &faster_}) {
        most_ = std::max(most_, std::abs(twin->at(t).position - position) / off);
      }
    } catch (const TimeStandsStill&) {
      most_ = never;
    }
    return most_;
  }

 private:
  static constexpr double off = 1e-9;
  static Exact twin(const OscillatingFloor& scene, const State<double>& by) {
    const State<double> start{scene.start.position + by.position,
                              scene.start.velocity + by.velocity};
    return {OscillatingFloorExact(scene), 0, start};
  }
  Exact higher_, faster_;
  double most_ = 1;
};

/// Whether the scene's own words say that the ball cannot be in that phase. Lengths are judged to
/// `rounding`, and forces to what that makes of a spring.
bool contradicts(const OscillatingFloor& scene, Phase phase, double t, const State<double>& ball,
                 double rounding) {
  const double floor = scene.floor_height(t), y = ball.position;
  const double gap = y - (scene.floor_law == FloorLaw::fixed_switch ? 0 : floor) - scene.radius;
  const double damped = scene.damped_velocity(t, ball.velocity);
  const double push = scene.stiffness * (scene.radius - y + floor) - scene.damping * damped;
  const double force = rounding * (scene.stiffness + 100 * scene.damping);
  if (phase == Phase::flight) return gap < -rounding;
  if (gap > rounding) return true;
  if (scene.contact == ContactLaw::may_pull) return false;
  return phase == Phase::touch ? push < -force : push > force;
}

}  // namespace

TEST_CASE("stage 6: the law of a phase is the scene's own law") {
  Dice dice(7);
  for (int n = 0; n < 3000; ++n) {
    const OscillatingFloor scene = dice.scene(n);
    const double t = dice.between(0, 10);
    const State<double> ball{scene.radius + scene.floor_height(t) + dice.between(-0.01, 0.01),
                             dice.between(-2, 2)};
    OscillatingFloorExact phases(scene);
    phases.begin(t - 0.3);
    // Which phase it is depends on the moment, which the law of a phase does not.
    OscillatingFloorExact now(scene);
    now.begin(t);
    const double got = phases.acceleration(now.phase_at(ball), 0.3, ball);
    const double expected = scene.acceleration(t, ball);
    // w t is up to 2000, rounded at 2e-13: so are the heights, 10 m at most, and speeds, A w.
    const double heights = scene.stiffness * 1e-11, speeds = scene.damping * 1e-11;
    CAPTURE(n);
    CHECK(std::abs(got - expected) < (heights + speeds) / scene.mass + 1e-12);
  }
}

TEST_CASE("stage 6: reference agrees with exact to 1e-10 m, under all laws") {
  Dice dice(20);
  int compared = 0, let_go = 0, over_damped = 0, resting = 0, busy = 0;
  for (int n = 0; n < 1000; ++n) {
    const OscillatingFloor scene = dice.scene(n);
    Exact exact(OscillatingFloorExact(scene), 0, scene.start);
    Sensitivity sensitivity(scene);
    HighOrder reference = reference_of(scene);
    CAPTURE(n);
    int events = 0;
    try {
      for (int i = 1; i <= 20; ++i) {
        const double t = 0.05 * i;
        for (; exact.next_event() <= t; ++events) {
          exact.pass_event();
          let_go += exact.phase() == Phase::let_go;
        }
        // A ball that hovers hands each hop's error on to the next: no start tells how much.
        if (events > 60 && scene.floor_law != FloorLaw::relative) break;
        const State<double> right = exact.at(t), got = at(reference, t);
        const double grown = sensitivity.at(t, right.position);
        if (grown > 1e4) break;  // chaos, or a ball that only just grazes the floor
        CAPTURE(t);
        CAPTURE(grown);
        // Each contact adds an error of 1e-12 of its speed times its duration, or of 1e-12 m/s; the
        // rest of the run makes it larger, as it does with a start that differs.
        CHECK(std::abs(got.position - right.position) < 1e-10 * grown);
        ++compared;
      }
    } catch (const TimeStandsStill&) {
      CHECK(scene.floor_law != FloorLaw::relative);
    }
    over_damped += scene.damping * scene.damping > 4 * scene.stiffness * scene.mass;
    resting += exact.next_event() == never;
    busy += events > 30;
  }
  INFO(compared, " positions; ", let_go, " times let go, ", over_damped, " over-damped, ", resting,
       " come to rest on the shaken floor, ", busy, " chatter");
  CHECK(compared > 15000);
  CHECK(let_go > 500);
  CHECK(over_damped > 300);
  CHECK(resting > 15);
  CHECK(busy > 50);
}

TEST_CASE("stage 6: with located events RK4 keeps its order 4 on a moving floor") {
  for (const FloorLaw law : {FloorLaw::relative, FloorLaw::absolute, FloorLaw::fixed_switch}) {
    for (const ContactLaw contact : {ContactLaw::may_pull, ContactLaw::push_only}) {
      for (const double damping : {0.0, 14.17, 120.0}) {
        OscillatingFloor scene;
        scene.floor_law = law;
        scene.contact = contact;
        scene.damping = damping;
        scene.start = {0.5, 0};
        scene.phase = 0.4;
        std::vector<double> dts, errors, without;
        for (int i = 0; i < 20; ++i) {
          // omega0 dt from 0.03 down to 0.008. Coarser, errors of the next order still count, and
          // without a damper they have the other sign.
          const int steps = static_cast<int>(3000 * std::pow(1.08, i));
          Located located(OscillatingFloorExact(scene), 0, scene.start);
          Exact exact(OscillatingFloorExact(scene), 0, scene.start);
          State<double> state = scene.start, plain = scene.start;
          double worst = 0, worst_plain = 0;
          for (int k = 0; k < steps; ++k) {
            const double t = double(k) / steps, end = double(k + 1) / steps;
            located(rk4_step, t, state, end);
            rk4(scene, t, plain, 1.0 / steps);
            if ((k + 1) % (steps / 20) != 0) continue;
            const double right = exact.at(end).position;
            worst = std::max(worst, std::abs(state.position - right));
            worst_plain = std::max(worst_plain, std::abs(plain.position - right));
          }
          dts.push_back(1.0 / steps);
          errors.push_back(worst);
          without.push_back(worst_plain);
        }
        CAPTURE(static_cast<int>(law));
        CAPTURE(static_cast<int>(contact));
        CAPTURE(damping);
        const double order = test::fitted_slope(dts, errors);
        const double order_without = test::fitted_slope(dts, without);
        INFO("measured order ", order, ", without located events ", order_without);
        CHECK(order > 3.5);
        CHECK(order < 4.6);
        CHECK(order_without < 2.7);  // 1 with a damper, 2 without, and chance
      }
    }
  }
}

TEST_CASE("stage 6: neither reference nor located steps skip the end of a phase") {
  Dice dice(30);
  int touches = 0, let_gos = 0, flights = 0;
  for (int n = 0; n < 10000; ++n) {
    OscillatingFloor scene = dice.scene(n);
    const double begin = dice.between(0, 100);
    // Near the floor, and slow against it: it is grazing movements whose ends are missed.
    const double scale = dice.between_powers(1e-5, 1);
    scene.start = {scene.floor_height(begin) + scene.radius + dice.between(-0.1, 0.05) * scale,
                   scene.floor_speed(begin) + dice.between(-1, 1) * std::sqrt(scale)};
    // 1e-12 of 10 m/s for a second, and rounding.
    constexpr double allowed = 2e-11;
    CAPTURE(n);

    HighOrder reference = reference_of(scene, begin);
    const Phase phase = reference.contacts().phase();
    (phase == Phase::flight ? flights : phase == Phase::touch ? touches : let_gos)++;
    int missed = 0;
    for (int piece = 0; piece < 20 && reference.contacts().phase() == phase; ++piece) {
      const double from = reference.last_event();
      HighOrder next = reference;
      next.reach(begin + 3, 1);
      const double to =
          std::min(next.last_event() > from ? next.last_event() : begin + 3, begin + 3);
      for (int i = 1; i < 8; ++i) {
        const double t = from + (to - from) * i / 8;
        missed += contradicts(scene, phase, t, reference.at(t), allowed);
      }
      if (next.last_event() == from) break;
      reference = next;
    }
    CHECK(missed == 0);

    // Steps as long as a third of a radian of the fastest that happens, where RK4 errs by about
    // (1/3)^5 / 120 of the movement in a step; those that keep the phase are looked at.
    Located located(OscillatingFloorExact(scene), begin, scene.start);
    const double dt = OscillatingFloorExact(scene).time_scale() / 3;
    State<double> state = scene.start;
    missed = 0;
    for (int k = 0; k < 12 && located.phase() == phase; ++k) {
      State<double> next = state;
      located(rk4_step, begin + k * dt, next, begin + (k + 1) * dt);
      if (located.phase() != phase || located.phase_start() != begin) break;
      missed += contradicts(scene, phase, begin + (k + 1) * dt, next, allowed);
      for (int i = 1; i < 4; ++i) {  // in between, by the same step cut short
        Located again(OscillatingFloorExact(scene), begin + k * dt, state);
        if (again.phase() != phase) break;
        State<double> within = state;
        again(rk4_step, begin + k * dt, within, begin + (k + i / 4.0) * dt);
        missed +=
            contradicts(scene, phase, begin + (k + i / 4.0) * dt, within, allowed + 1e-5 * scale);
      }
      state = next;
    }
    CHECK(missed == 0);
  }
  CHECK(flights > 1000);
  CHECK(touches > 1500);
  CHECK(let_gos > 50);
}

TEST_CASE("stage 6: a ball that stays on the shaken floor is followed for as long as one likes") {
  OscillatingFloor scene;
  scene.amplitude = 0.005;
  for (const double begin : {0.0, 1e5}) {
    // At 1e5 s the time itself is rounded at 1.5e-11 s, and the floor has up to 0.06 m/s.
    scene.start = {scene.radius + scene.floor_height(begin) - 9.81e-4, scene.floor_speed(begin)};
    Exact exact(OscillatingFloorExact(scene), begin, scene.start);
    HighOrder reference = reference_of(scene, begin);
    for (int i = 1; i <= 20; ++i) {
      const double t = begin + 0.5 * i;
      CAPTURE(t);
      CHECK(std::abs(at(reference, t).position - exact.at(t).position) < 1e-12 + 1e-16 * begin);
    }
    // The error control sees no rounding of w t: the contact's own rate decides, not the clock.
    CHECK(reference.pieces() < 20000);
  }
}

TEST_CASE("stage 6: who looks at a run does not change it, and a saved run goes on to the bit") {
  for (const Method method : {methods::reference, methods::rk4_events, methods::flight_rk4}) {
    for (const char* law : {"relative", "absolute", "fixed-switch"}) {
      const auto fresh = [&] {
        FloorRun run;
        set(run, "floor_law", law);
        set(run, "contact", "push-only");
        run.use_method(method);
        run.restart();
        return run;
      };
      FloorRun whole = fresh(), parts = fresh();
      whole.advance_to(3);
      for (int i = 1; i <= 30; ++i) {
        parts.advance_to(i * 0.1);
        FloorRun again = fresh();
        again.recall(parts.memory());
        parts = again;
      }
      CAPTURE(name_of(method));
      CAPTURE(law);
      if (method == methods::reference) {
        CHECK(parts.values() == whole.values());
      } else {  // the cuts lie on whole steps; only the rounding of the times differs
        CHECK(parts.values()[1] == doctest::Approx(whole.values()[1]).epsilon(1e-11));
      }
    }
  }
}

TEST_CASE("stage 6: all of its methods stand on the command line, and hovering ends with code 3") {
  const std::string name = "06_oscillating_floor --headless ";
  const test::Outcome list = test::run_program(name + "--list");
  CHECK(list.out.find("rk4, rk4-events, flight-rk4, reference, exact") != std::string::npos);
  for (const std::string method : {"rk4-events", "flight-rk4", "reference"}) {
    CAPTURE(method);
    const test::Outcome run = test::run_program(name + "--method " + method);
    CHECK(run.code == 0);
    CHECK(run.err.find("position_error_m=") != std::string::npos);
    const test::Outcome hovers = test::run_program(name +
                                                   "--set floor_law=absolute --set damping=300 "
                                                   "--set angular_frequency=1 --method " +
                                                   method);
    CHECK(hovers.code == 3);
    CHECK(hovers.err.find("no longer advance time at t = 2.24") != std::string::npos);
  }
}
