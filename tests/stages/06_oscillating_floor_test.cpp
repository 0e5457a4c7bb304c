#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "03_damping/exact.hpp"
#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "methods.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/text.hpp"
#include "random_numbers.hpp"
#include "run_program.hpp"

using namespace bounce;
using test::all_methods;

namespace {

using Walker = EventDriven<OscillatingFloorExact>;
constexpr double pi = std::numbers::pi;
constexpr auto laws = {FloorLaw::relative, FloorLaw::absolute, FloorLaw::fixed_switch};
constexpr auto contacts = {ContactLaw::may_pull, ContactLaw::push_only};

Walker exact_of(const OscillatingFloor& scene, double t = 0) {
  return Walker(OscillatingFloorExact(scene), t, scene.start);
}

/// A ball that meets a floor in uniform motion, without gravity; how fast it leaves, seen from the
/// floor, per speed at which it came.
OscillatingFloor meeting(double floor_velocity, FloorLaw law) {
  OscillatingFloor scene;
  scene.mass = 0.37;
  scene.gravity = 0;
  scene.stiffness = 812.3;
  scene.damping = 2.9;
  scene.amplitude = 0;
  scene.floor_velocity = floor_velocity;
  scene.floor_law = law;
  scene.start = {scene.radius + 0.1, floor_velocity - 4.7};
  return scene;
}

double exact_restitution(const OscillatingFloor& scene) {
  Walker walker = exact_of(scene);
  while (walker.next_event() != never) walker.pass_event();
  return (walker.state_at_last_event().velocity - scene.floor_velocity) / 4.7;
}

template <class Step>
double stepped_restitution(const OscillatingFloor& scene, Step step, double dt) {
  State<double> state = scene.start;
  bool touched = false;
  for (int i = 0; i < 10000000; ++i) {
    const bool touches = scene.touches(state.position, scene.floor_height(i * dt));
    if (touched && !touches) return (state.velocity - scene.floor_velocity) / 4.7;
    touched |= touches;
    step(scene, i * dt, state, dt);
  }
  return 0;
}

/// The oracle: plain RK4 with tiny steps in one regime of the force (free, or spring and damper),
/// which changes at a moment found by halving the step. It shares no line with the exact solution.
class PlainRk4 {
 public:
  explicit PlainRk4(const OscillatingFloor& scene) : p_(scene), y_(p_.start.position) {
    v_ = p_.start.velocity;
    pushing_ = should_push(0, y_, v_);
  }
  State<double> at(double end, double dt) {
    while (t_ < end) {
      double h = std::min(dt, end - t_);
      State<double> next = step(h);
      if (should_push(t_ + h, next.position, next.velocity) != pushing_) {
        double before = 0, after = h;
        for (int i = 0; i < 60; ++i) {
          h = (before + after) / 2;
          next = step(h);
          (should_push(t_ + h, next.position, next.velocity) == pushing_ ? before : after) = h;
        }
        h = after;
        next = step(h);
        pushing_ = !pushing_;
      }
      t_ += h;
      y_ = next.position;
      v_ = next.velocity;
    }
    return {y_, v_};
  }

 private:
  double floor(double t) const {
    return p_.floor_velocity * t + p_.amplitude * std::sin(p_.angular_frequency * t + p_.phase);
  }
  double floor_rate(double t) const {
    const double w = p_.angular_frequency;
    return p_.floor_velocity + p_.amplitude * w * std::cos(w * t + p_.phase);
  }
  double push(double t, double y, double v) const {
    const double damped = p_.floor_law == FloorLaw::relative ? v - floor_rate(t) : v;
    return p_.stiffness * (p_.radius - (y - floor(t))) - p_.damping * damped;
  }
  bool should_push(double t, double y, double v) const {
    const double level = p_.floor_law == FloorLaw::fixed_switch ? 0 : floor(t);
    if (!(y - level < p_.radius)) return false;
    return p_.contact == ContactLaw::may_pull || push(t, y, v) > 0;
  }
  double a(double t, double y, double v) const {
    return (pushing_ ? push(t, y, v) / p_.mass : 0) - p_.gravity;
  }
  State<double> step(double h) const {
    const double a1 = a(t_, y_, v_), v1 = v_;
    const double v2 = v_ + a1 * h / 2, a2 = a(t_ + h / 2, y_ + v1 * h / 2, v2);
    const double v3 = v_ + a2 * h / 2, a3 = a(t_ + h / 2, y_ + v2 * h / 2, v3);
    const double v4 = v_ + a3 * h, a4 = a(t_ + h, y_ + v3 * h, v4);
    return {y_ + h * (v1 + 2 * v2 + 2 * v3 + v4) / 6, v_ + h * (a1 + 2 * a2 + 2 * a3 + a4) / 6};
  }

  OscillatingFloor p_;
  double t_ = 0, y_, v_;
  bool pushing_;
};

void check_against_rk4(const OscillatingFloor& scene) {
  // Between events RK4 errs by about (omega0 dt)^4 / 120 of the movement in a radian of contact:
  // (100 * 1e-5)^4 / 120 < 1e-14. Rounding of 1e5 steps a second is 1e-16 * sqrt(1e5) and more, and
  // every bounce multiplies it by about 3 (a shift of the impact shifts the floor's speed, too).
  // Five bounces: 3^5 * 1e-13 < 3e-11.
  Walker walker = exact_of(scene);
  PlainRk4 plain(scene);
  for (double t = 0.05; t < 1.0; t += 0.05) {
    const State<double> got = walker.at(t), expected = plain.at(t, 1e-5);
    CAPTURE(t);
    INFO("y: got ", got.position, ", expected ", expected.position, "; v: got ", got.velocity,
         ", expected ", expected.velocity);
    CHECK(std::abs(got.position - expected.position) < 3e-11);
    CHECK(std::abs(got.velocity - expected.velocity) < 3e-9);
  }
}

}  // namespace

// ---- The law ------------------------------------------------------------------------------------

TEST_CASE("stage 6: a floor at constant speed bounces a ball as one at rest does (relative law)") {
  for (const double u : {-4.0, -2.0, 0.0, 2.0, 4.0}) {
    const OscillatingFloor scene = meeting(u, FloorLaw::relative);
    CAPTURE(u);
    INFO("the damper must act on the velocity relative to the floor");
    // Six digits are given in the literature's formula e = exp(-beta t_c).
    CHECK(std::abs(exact_restitution(scene) - 0.768217) < 5e-7);
    for (const double dt : {4e-5, 1e-5}) {
      CAPTURE(dt);
      // Entry and exit are seen up to a step late: the damper's force jumps there by c v, and the
      // spring is cut at up to v dt: relative errors of c dt / m = 8 dt and (omega0 dt)^2.
      const double e = stepped_restitution(
          scene, [](auto& s, double t, auto& x, double h) { semi_implicit_euler(s, t, x, h); }, dt);
      CHECK(std::abs(e - 0.768217) < 50 * dt);
      const double e4 = stepped_restitution(
          scene, [](auto& s, double t, auto& x, double h) { rk4(s, t, x, h); }, dt);
      CHECK(std::abs(e4 - 0.768217) < 50 * dt);
    }
  }
}

TEST_CASE("stage 6: an absolute damper knows who watches") {
  const std::array<std::array<double, 2>, 5> known{
      {{-4, 0.805403}, {-2, 0.787982}, {0, 0.768217}, {2, 0.745742}, {4, 0.720125}}};
  for (const std::array<double, 2>& row : known) {
    const double u = row[0], e = row[1];
    const OscillatingFloor scene = meeting(u, FloorLaw::absolute);
    CAPTURE(u);
    CHECK(std::abs(exact_restitution(scene) - e) < 5e-7);
    const double stepped = stepped_restitution(
        scene, [](auto& s, double t, auto& x, double h) { rk4(s, t, x, h); }, 1e-5);
    CHECK(std::abs(stepped - e) < 50e-5);
  }
}

TEST_CASE("stage 6: on a rising floor an absolute damper presses the ball in by c u / k") {
  OscillatingFloor scene = meeting(2, FloorLaw::absolute);
  scene.gravity = 9.80665;
  scene.start = {0.05, 2};
  const double t = 20;  // beta t = 78: nothing is left of the start
  const double height = exact_of(scene).at(t).position - scene.floor_height(t);
  const double sag = scene.mass * scene.gravity / scene.stiffness;
  CHECK(std::abs(height - (scene.radius - sag - 2.9 * 2 / 812.3)) < 1e-13);
  scene.floor_law = FloorLaw::relative;
  CHECK(std::abs(exact_of(scene).at(t).position - scene.floor_height(t) - (scene.radius - sag)) <
        1e-13);
}

TEST_CASE("stage 6: seen from a floor in uniform motion nothing changes, with gravity either") {
  for (const ContactLaw contact : contacts) {
    OscillatingFloor rest;
    rest.contact = contact;
    OscillatingFloor moving = rest;
    moving.floor_velocity = 3;
    moving.start.velocity = 3;
    Walker a = exact_of(rest), b = exact_of(moving);
    for (double t = 0.1; t < 3; t += 0.1) {
      CAPTURE(t);
      // Heights of up to 10 m are rounded at 1e-15, and each of 7 bounces triples that.
      CHECK(std::abs(b.at(t).position - 3 * t - a.at(t).position) < 1e-11);
    }
  }
}

TEST_CASE("stage 6: the slides' switch pulls a ball down through air") {
  // The floor stands 50 mm below, and the ball has sunk 0.5 mm below y = r: the "spring" is
  // stretched by 49.5 mm. By formula, with the damper: v = -(a0/omega_d) e^(-beta t) sin(omega_d
  // t).
  OscillatingFloor scene;
  scene.mass = 0.1;
  scene.stiffness = 1000;
  scene.damping = 0.4;
  scene.amplitude = 0.05;
  scene.angular_frequency = 0;
  scene.phase = -pi / 2;
  scene.start = {0.0995, 0};
  scene.floor_law = FloorLaw::fixed_switch;
  CHECK(scene.force(0, scene.start) + 0.981 == doctest::Approx(-49.5));
  const double a0 = (49.5 + 0.981) / 0.1, beta = 2, omega_d = std::sqrt(1e4 - 4);
  const double v = -a0 / omega_d * std::exp(-beta * 0.005) * std::sin(omega_d * 0.005);
  CHECK(v == doctest::Approx(-2.396).epsilon(2e-4));
  CHECK(exact_of(scene).at(0.005).velocity == doctest::Approx(v).epsilon(1e-12));
  // First-order methods err by a0 omega0 dt / 2 a second and less.
  for (const auto& method : all_methods<OscillatingFloor>()) {
    for (const int steps : {500, 5000}) {
      INFO(method.name, " with ", steps, " steps");
      const double got = test::run(scene, method, 0.005 / steps, steps).velocity;
      CHECK(std::abs(got - v) < a0 * 0.005 / steps);
    }
  }
  scene.floor_law = FloorLaw::relative;
  INFO("above the floor nothing but gravity may act");
  CHECK(exact_of(scene).at(0.005).velocity == doctest::Approx(-0.04905).epsilon(1e-12));
}

// ---- Special cases that must come out as before -------------------------------------------------

TEST_CASE("stage 6: without amplitude it is stage 3, to the bit") {
  for (const ContactLaw contact : contacts) {
    Damping still;
    still.damping = 14.17;
    still.contact = contact;
    still.start = {0.5, 0};
    OscillatingFloor scene;
    scene.amplitude = 0;
    scene.contact = contact;
    scene.start = still.start;
    for (const FloorLaw law : laws) {
      scene.floor_law = law;
      const auto before = all_methods<Damping>();
      const auto now = all_methods<OscillatingFloor>();
      for (std::size_t i = 0; i < now.size(); ++i) {
        INFO(now[i].name, ": adding a floor height of 0 may not round anything");
        const State<double> expected = test::run(still, before[i], 1e-4, 30000);
        const State<double> got = test::run(scene, now[i], 1e-4, 30000);
        CHECK(got.position == expected.position);
        CHECK(got.velocity == expected.velocity);
      }
      // The exact solutions use different formulas: rounding, which each of the bounces in 3 s
      // (fewer than 10, e = 0.8) divides by e: 1e-16 * 1.25^10 < 1e-15, and v t_rounding besides.
      EventDriven<DampingExact> right(DampingExact(still), 0, still.start);
      Walker walker = exact_of(scene);
      for (double t = 0.05; t < 3; t += 0.05) {
        CAPTURE(t);
        CHECK(std::abs(walker.at(t).position - right.at(t).position) < 2e-14);
      }
    }
  }
}

TEST_CASE("stage 6: a ball at rest on a floor that is shaken more and more stays until A w^2 = g") {
  // A(t) grows from 0 to 70 mm in 60 s; at 2 Hz, A w^2 = g at 62.1 mm. Nothing is stirred up, so
  // the ball stays on the floor; omega0 is 8 w, which lowers the limit by (w/omega0)^2 = 1.6 %.
  OscillatingFloor scene;
  scene.angular_frequency = 4 * pi;
  const double sag = scene.mass * scene.gravity / scene.stiffness;
  for (const double dt : {2e-4, 1e-4}) {
    State<double> state{scene.radius - sag, 0};
    double lifted = 0;
    for (int i = 0; lifted == 0 && i * dt < 60; ++i) {
      const double t = i * dt;
      scene.amplitude = 0.07 * t / 60;
      rk4(scene, t, state, dt);
      if (state.position - scene.floor_height(t + dt) >= scene.radius) lifted = scene.amplitude;
    }
    CAPTURE(dt);
    const double limit = scene.gravity / (16 * pi * pi);
    CHECK(lifted < limit * 1.01);  // the amplitude grows 0.6 mm a swing
    CHECK(lifted > limit * 0.97);
  }
}

TEST_CASE("stage 6: a sudden start shakes the ball off much earlier") {
  // At t = 0 the floor starts with its full speed A w: seen from the floor, the ball is thrown at
  // it. The contact rings, x = (A w / omega_d) e^(-beta t) sin(omega_d t), and opens in its first
  // swing upwards, where it passes the sag g / omega0^2, if A is above g e^(beta t) / (omega0 w)
  // with omega_d t = 3 pi / 2: 10.9 mm. By then the floor falls away with A w^2 sin(w t), which
  // helps.
  OscillatingFloor scene;
  scene.angular_frequency = 4 * pi;
  const double w = scene.angular_frequency, g = scene.gravity;
  scene.start = {scene.radius - scene.mass * g / scene.stiffness, 0};
  double stays = 0, flies = 0.03;
  while (flies - stays > 1e-7) {
    scene.amplitude = (stays + flies) / 2;
    Walker walker = exact_of(scene);
    bool flown = false;
    while (walker.next_event() < 10 && !flown) {
      walker.pass_event();
      flown = walker.phase() == Phase::flight;
    }
    (flown ? flies : stays) = scene.amplitude;
  }
  const double beta = scene.damping / 2, omega_d = std::sqrt(1e4 - beta * beta);
  const double t = 1.5 * pi / omega_d;
  const double ringing = 100 * w * std::exp(-beta * t), fall = w * w * std::sin(w * t);
  const double estimate = g / (ringing + fall);  // 9.9 mm
  INFO("lifts off from A = ", flies, " on, estimate ", estimate);
  // The estimate takes the floor's acceleration as constant over the swing, and the moment as that
  // of the undisturbed ringing: both good to (w/omega0)^2 and beta/omega0 of a part of 10 %.
  CHECK(std::abs(flies / estimate - 1) < 0.03);
}

// ---- The exact solution -------------------------------------------------------------------------

TEST_CASE("stage 6: exact against plain RK4, three floor laws and two contact laws") {
  for (const FloorLaw law : laws) {
    for (const ContactLaw contact : contacts) {
      for (const double damping : {0.0, 14.17, 199.0, 320.0}) {
        OscillatingFloor scene;
        scene.floor_law = law;
        scene.contact = contact;
        scene.damping = damping;
        scene.phase = 0.7;
        scene.floor_velocity = 0.05;
        INFO("floor law ", static_cast<int>(law), ", contact ", static_cast<int>(contact),
             ", damping ", damping);
        check_against_rk4(scene);
      }
    }
  }
}

TEST_CASE("stage 6: resonance is no special case") {
  for (const double off : {0.0, 1e-12, 1e-7, 1e-3}) {
    OscillatingFloor scene;
    scene.damping = 0;
    scene.angular_frequency = 100 * (1 + off);  // omega0 = 100
    scene.amplitude = 0.0003;
    scene.start = {0.0985, 0.0};
    CAPTURE(off);
    INFO("the shaken oscillator divides by omega0^2 - w^2");
    check_against_rk4(scene);
  }
}

TEST_CASE("stage 6: no change of phase is missed") {
  std::mt19937_64 random(6);
  const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
  int flights = 0, touches = 0, let_gos = 0;
  for (int n = 0; n < 24000; ++n) {
    OscillatingFloor scene;
    scene.floor_law = static_cast<FloorLaw>(n % 3);
    scene.contact = n % 2 == 0 ? ContactLaw::may_pull : ContactLaw::push_only;
    scene.damping = n % 5 == 0 ? 0 : uniform(0, 250);
    // Over-damped up to zeta = 5000: there the fast exponential's bound is dropped as it decays.
    if (n % 5 == 1) scene.damping = std::exp(uniform(std::log(200.0), std::log(1e6)));
    scene.angular_frequency = std::exp(uniform(std::log(1.0), std::log(300.0)));
    scene.amplitude = 9.81 / std::pow(scene.angular_frequency, 2) * std::exp(uniform(-2, 2));
    scene.phase = uniform(0, 2 * pi);
    scene.floor_velocity = n % 7 == 0 ? uniform(-1, 1) : 0;
    const double begin = uniform(0, 100);
    // Near the floor, and slow against it: grazing flights are the ones that are missed.
    const double scale = std::exp(uniform(-12, 0));
    const State<double> start{scene.floor_height(begin) + scene.radius + uniform(-0.1, 0.1) * scale,
                              scene.floor_speed(begin) + uniform(-2, 2) * std::sqrt(scale)};

    OscillatingFloorExact phases(scene);
    phases.begin(begin);
    const Phase phase = phases.phase_at(start);
    const PhaseEnd end = phases.end_of(phase, start);
    const double length = std::min(end.after, 3.0);

    // What holds in each phase, from the scene's own words.
    const auto violated = [&](double t, double tolerance) {
      const State<double> ball = phases.move(phase, start, t);
      const double floor = scene.floor_height(begin + t), y = ball.position;
      const double level = scene.floor_law == FloorLaw::fixed_switch ? 0 : floor;
      const double gap = y - level - scene.radius;
      const double damped = scene.damped_velocity(begin + t, ball.velocity);
      const double push = scene.stiffness * (scene.radius - y + floor) - scene.damping * damped;
      const bool clamps = scene.contact == ContactLaw::push_only;
      if (phase == Phase::flight) return gap < -tolerance;
      if (gap > tolerance) return true;
      const double force = (scene.stiffness + scene.damping) * tolerance;
      return clamps && (phase == Phase::touch ? push < -force : push > force);
    };
    (phase == Phase::flight ? flights : phase == Phase::touch ? touches : let_gos)++;
    CAPTURE(n);
    CAPTURE(static_cast<int>(phase));
    CAPTURE(end.after);
    // Rounding of w t near t = 100 is 1e-14 * w: 3e-12 rad of a swing of 1 m at w = 1.
    constexpr double rounding = 2e-12;
    int missed = 0;
    for (int i = 1; i < 300; ++i) missed += violated(length * i / 300, rounding);
    CHECK(missed == 0);
    // And it does end there: a little later the phase's own words are broken.
    if (end.after < 3 && end.next != phase && end.after > 1e-6) {
      const double later = 1e-5 * end.after + 1e-7;
      INFO("a phase ended for nothing");
      CHECK((violated(end.after + later, 0) || violated(end.after + 30 * later, 0)));
    }
  }
  CHECK(flights > 10000);
  CHECK(touches > 7000);
  CHECK(let_gos > 500);
}

TEST_CASE("stage 6: a strong damper costs no more than a weak one, however light the ball") {
  // A damping ratio of 1000 on a grain of 1e-12 kg: rates of 2e11 and 5e4 per second. The search
  // may take a few hundred steps while the fast one dies, and not for the whole contact, which
  // lasts for seconds.
  for (const double zeta : {2.0, 100.0, 1000.0, 5000.0}) {
    for (const ContactLaw contact : contacts) {
      OscillatingFloor scene;
      scene.mass = 1e-12;
      scene.damping = 2 * zeta * std::sqrt(scene.mass * scene.stiffness);
      scene.contact = contact;
      Walker walker = exact_of(scene);
      int events = 0;
      for (; walker.next_event() < 10 && events < 1000; ++events) walker.pass_event();
      CAPTURE(zeta);
      CAPTURE(static_cast<int>(contact));
      CHECK(events < 1000);
      // So light a ball, so strongly damped, lies on the floor: A w^2 is less than g, and its lag
      // behind the floor, c / k = 2 zeta / omega0 = 1e-4 s at most, squared, times A w^2.
      CHECK(std::abs(walker.at(10).position - scene.floor_height(10) - scene.radius) < 1e-6);
    }
  }
}

TEST_CASE("stage 6: after 1e6 s the floor is still where it belongs") {
  // From t = 1e6 s against the same movement from t = 0 with the phase that the floor then has, in
  // long double (64 bits of mantissa; where that is a double the test still holds).
  OscillatingFloor late;
  late.angular_frequency = 12.6;
  OscillatingFloor early = late;
  const long double turn = 2 * std::acos(-1.0L);
  early.phase = static_cast<double>(std::fmod(static_cast<long double>(12.6) * 1e6L, turn));
  Walker a = exact_of(early), b = exact_of(late, 1e6);
  for (double t = 0.1; t < 3; t += 0.1) {
    CAPTURE(t);
    // w t = 1.26e7 is rounded by 9e-10 rad, 7e-11 s; so is the time itself, by 6e-11 s. That shifts
    // each impact by some 1e-10 s at 5 m/s, and 7 bounces multiply a shift by up to 3 each.
    CHECK(std::abs(b.at(1e6 + t).position - a.at((1e6 + t) - 1e6).position) < 5e-10 * 2200);
  }

  // A ball that stays is carried there by one formula: here nothing is rounded but w t.
  OscillatingFloor calm;
  calm.amplitude = 0.005;
  calm.start = {calm.radius - 9.81e-4, calm.amplitude * calm.angular_frequency};
  Walker walker = exact_of(calm);
  while (walker.next_event() < 100) walker.pass_event();
  CHECK(walker.next_event() == never);
  const double w = calm.angular_frequency;  // the steady swing: the ball's follows the floor's by
  const Complex follow = Complex(1e4, 14.17 * w) / Complex(1e4 - w * w, 14.17 * w) * calm.amplitude;
  for (const double t : {1e3, 1e6}) {
    const double swing = (follow * std::polar(1.0, std::fmod(w * t, 2 * pi))).imag();
    CHECK(std::abs(walker.at(t).position - (calm.radius - 9.81e-4 + swing)) < 1e-10);
  }
}

TEST_CASE("stage 6: a thousand periodic bounces do not wear out") {
  OscillatingFloor scene;
  scene.amplitude = 0.06;
  const std::vector<Bounce> bounces = settled_bounces(scene, 20000, 10);  // 1e4 s
  REQUIRE(bounces.size() == 10);
  const std::vector<Bounce> young = settled_bounces(scene, 300, 1);
  for (const Bounce& bounce : bounces) {
    // This bounce attracts its neighbours: rounding of w t = 1e5 (1e-11 rad) is not amplified.
    CHECK(std::abs(bounce.height - young[0].height) < 1e-10);
  }
}

TEST_CASE("stage 6: a ball that hovers on the edge of an unphysical contact is told apart") {
  OscillatingFloor scene;
  scene.floor_law = FloorLaw::absolute;
  scene.damping = 300;
  scene.angular_frequency = 1;
  Walker walker = exact_of(scene);
  CHECK_THROWS_AS(walker.at(10), TimeStandsStill);
  const test::Outcome run = test::run_program(
      "06_oscillating_floor --headless --method exact --set floor_law=absolute --set damping=300 "
      "--set angular_frequency=1");
  CHECK(run.code == 3);
  CAPTURE(run.err);
  CHECK(run.err.find("no longer advance time") != std::string::npos);
}

// ---- The demo's parts that are not drawing ------------------------------------------------------

TEST_CASE("stage 6: a slider does not make the floor jump") {
  std::mt19937_64 random(66);
  const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
  for (int n = 0; n < 2000; ++n) {
    OscillatingFloor before;
    before.amplitude = uniform(0.01, 0.1);
    before.angular_frequency = uniform(0, 40);
    before.phase = uniform(0, 6.28);
    const double t = uniform(0, 600);
    const double height = before.floor_height(t), speed = before.floor_speed(t);
    OscillatingFloor after = before;
    after.angular_frequency = uniform(0, 40);
    after.phase = phase_without_jump(before, after, t);
    // The angle w t is at most 24000, rounded at 4e-12.
    CHECK(std::abs(after.floor_height(t) - height) < 1e-11);
    CHECK(after.floor_speed(t) * speed >= 0);

    after = before;
    after.amplitude = uniform(0, 0.1);
    after.phase = phase_without_jump(before, after, t);
    INFO("amplitude ", before.amplitude, " -> ", after.amplitude);
    if (after.amplitude > std::abs(height) * (1 + 1e-9)) {
      // Near the turning point the angle is known to sqrt(rounding) only; the height is not worse.
      CHECK(std::abs(after.floor_height(t) - height) < 1e-11);
      if (std::abs(speed) > 1e-3) CHECK(after.floor_speed(t) * speed >= 0);
    } else {
      INFO("as near as the new amplitude lets it");
      CHECK(std::abs(std::abs(after.floor_height(t)) - after.amplitude) < 1e-11);
    }
  }
}

TEST_CASE("stage 6: one height, two, four, many") {
  OscillatingFloor scene;
  scene.angular_frequency = 4 * pi;
  scene.contact = ContactLaw::push_only;
  const auto heights = [&](double amplitude) {
    scene.amplitude = amplitude;
    std::vector<double> all;
    for (const Bounce& bounce : settled_bounces(scene, 600, 64)) {
      CHECK(bounce.phase >= 0);
      CHECK(bounce.phase < 2 * pi);
      const auto same = [&](double h) { return std::abs(h - bounce.height) < 1e-4; };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(bounce.height);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  CHECK(heights(0.056).size() == 1);
  CHECK(heights(0.062).size() == 1);
  CHECK(heights(0.062)[0] == doctest::Approx(0.43).epsilon(0.02));
  CHECK(heights(0.074).size() == 2);
  CHECK(heights(0.082).size() > 30);
  scene.start.position = 0.82;  // from here the way to the four does not lead through chaos
  CHECK(heights(0.0765).size() == 4);
  scene.start.position = 0.8;

  // A hard ball with restitution e doubles at Gamma = A w^2 / g (Holmes 1982, with his return map
  // taken exactly): Gamma^2 = (pi (1-e)/(1+e))^2 + (2 (1+e^2)/(1+e)^2)^2. Ours is soft: a contact
  // lasts 30 ms of 500, and so the two agree to a few per cent only.
  double one = 0.062, two = 0.074;
  while (two - one > 1e-5) {
    const double middle = (one + two) / 2;
    (heights(middle).size() == 1 ? one : two) = middle;
  }
  const double e = restitution({scene.stiffness, scene.damping, scene.contact}, scene.mass);
  const double gamma = std::hypot(pi * (1 - e) / (1 + e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
  const double hard = gamma * scene.gravity / std::pow(scene.angular_frequency, 2);
  INFO("doubles at ", one, ", a hard ball at ", hard);
  CHECK(std::abs(one / hard - 1) < 0.03);
}

TEST_CASE("stage 6: chaos: a micrometre is a centimetre four seconds later") {
  OscillatingFloor scene;
  scene.angular_frequency = 4 * pi;
  scene.contact = ContactLaw::push_only;
  const auto parted = [&](double amplitude) {
    scene.amplitude = amplitude;
    OscillatingFloor twin = scene;
    twin.start.position += 1e-6;
    Walker a = exact_of(scene), b = exact_of(twin);
    double t = 0;
    while (t < 60 && std::abs(a.at(t).position - b.at(t).position) < 0.01) t += 0.01;
    return t;
  };
  CHECK(parted(0.070) >= 60);
  CHECK(parted(0.082) < 10);
}

TEST_CASE("stage 6: the command line: columns, laws, sweep, bad input") {
  const std::string name = "06_oscillating_floor ";
  const test::Outcome rows = test::run_program(name + "--csv - --at 0.5,1 --method exact");
  CHECK(rows.code == 0);
  CHECK(rows.out.rfind("t,floor,y,v\n0.5,", 0) == 0);
  const test::Outcome sweep =
      test::run_program(name + "--sweep amplitude=0.05,0.06,3 --csv - --set contact=push-only");
  CHECK(sweep.code == 0);
  CHECK(sweep.out.rfind("amplitude,phase,height\n0.05,", 0) == 0);
  CHECK(std::count(sweep.out.begin(), sweep.out.end(), '\n') == 301);
  for (const std::string bad :
       {"--sweep amplitude=0.05,0.06,3", "--sweep amplitude --csv -",
        "--sweep amplitude=0.05,0.06 --csv -", "--sweep amplitude=0.05,x,3 --csv -",
        "--sweep amplitude=-1,0.06,3 --csv -", "--sweep amplitude=0.05,0.06,1 --csv -",
        "--sweep amplitude=0.05,0.06,2.5 --csv -", "--sweep amplitude=0.06,0.05,3 --csv -",
        "--sweep amplitud=0.05,0.06,3 --csv -", "--sweep contact=0,1,3 --csv -",
        "--sweep '' --csv -", "--sweep amplitude=nan,1,3 --csv -", "--set amplitude=-0.1",
        "--set angular_frequency=inf", "--set floor_law=hard", "--set phase=x"}) {
    const test::Outcome run = test::run_program(name + "--headless " + bad);
    INFO(bad, ": ", run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
  }
}
