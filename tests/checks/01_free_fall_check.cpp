#include <doctest/doctest.h>

#include "checks/law.hpp"

namespace bounce::check::free_fall {
namespace {

std::vector<Moment> moments() {
  Dice dice(1);
  std::vector<Moment> all;
  for (int i = 0; i < 20; ++i) {
    all.push_back({any_setting(dice),
                   dice.between(0, 3),
                   {up(dice.between(-5, 5)), up(dice.between(-5, 5))}});
  }
  return all;
}

std::string falling(const Moment& m) {
  return "mass " + number(m.setting.mass) + " kg, gravity " + number(m.setting.gravity) +
         " m/s^2, y = " + number(m.y()) + " m, v = " + number(m.v()) + " m/s";
}

/// One turn of the loop, with an acceleration that depends on everything.
struct Turn {
  LinearLaw law;
  double t, y, v, dt;
  double a() const { return law(t, y, v); }
};

Triple y_and_v(double y, double v) { return {y, v, 0}; }

Question<Turn> loop_question(const Turn& first) {
  Question<Turn> q;
  q.tested = "position and velocity after one step of the loop";
  q.names = {"y [m]", "v [m/s]", ""};
  q.lesson = "docs/01_free_fall.md, \"The idea\"";
  q.answer = [](const Turn& s) {
    const Motion after = subject().step(s.law, s.t, {up(s.y), up(s.v)}, s.dt);
    return y_and_v(after.position[1], after.velocity[1]);
  };
  q.truth = [](const Turn& s) {
    const double v = s.v + s.a() * s.dt;
    return y_and_v(s.y + v * s.dt, v);
  };
  q.rounding = [](const Turn&) { return 1e-13; };  // numbers up to 30, rounded a few times
  q.where = [](const Turn& s) {
    return "from y = " + number(s.y) + " m, v = " + number(s.v) + " m/s, with an acceleration of " +
           number(s.a()) + " m/s^2 there";
  };
  q.when = [](const Turn& s) { return "t = " + number(s.t) + " s, dt = " + number(s.dt) + " s"; };
  q.look_at =
      "three lines: the acceleration from the scene at (t, state), the velocity from the "
      "acceleration, the position from the velocity.";
  q.suspects = {
      {"position before velocity",
       "the position moved with the velocity from before the step. That is explicit Euler; the "
       "loop of this stage changes the velocity first, and moves with the new one.",
       [](const Turn& s) { return y_and_v(s.y + s.v * s.dt, s.v + s.a() * s.dt); }},
      {"dt twice", "the velocity changes by acceleration * dt. Is there a dt too many?",
       [](const Turn& s) {
         const double v = s.v + s.a() * s.dt * s.dt;
         return y_and_v(s.y + v * s.dt, v);
       }},
      {"dt twice", "the position changes by velocity * dt. Is there a dt too many?",
       [](const Turn& s) {
         const double v = s.v + s.a() * s.dt;
         return y_and_v(s.y + v * s.dt * s.dt, v);
       }},
      {"dt forgotten", "a change is a rate times dt: acceleration * dt, and velocity * dt.",
       [](const Turn& s) { return y_and_v(s.y + s.v + s.a(), s.v + s.a()); }},
      {"dt forgotten", "the velocity changes by acceleration * dt.",
       [](const Turn& s) {
         const double v = s.v + s.a();
         return y_and_v(s.y + v * s.dt, v);
       }},
      {"the velocity stays", "only the position moved. The acceleration changes the velocity.",
       [](const Turn& s) { return y_and_v(s.y + s.v * s.dt, s.v); }},
      {"the position stays", "only the velocity changed. The velocity moves the position.",
       [](const Turn& s) { return y_and_v(s.y, s.v + s.a() * s.dt); }},
      {"nothing moves",
       "position and velocity stay as they were. If this gap is still empty, that is "
       "why.",
       [](const Turn& s) { return y_and_v(s.y, s.v); }},
  };
  const auto part = [&](const char* name, double wanted, auto value) {
    q.parts.push_back({name, wanted, value});
  };
  using T = const Turn&;
  part("the old y", 1, [](T s) { return y_and_v(s.y, 0); });
  part("the old v (in v)", 1, [](T s) { return y_and_v(0, s.v); });
  part("v dt (in y)", 1, [](T s) { return y_and_v(s.v * s.dt, 0); });
  part("a dt (in v)", 1, [](T s) { return y_and_v(0, s.a() * s.dt); });
  part("a dt^2 (in y, from the new velocity)", 1,
       [](T s) { return y_and_v(s.a() * s.dt * s.dt, 0); });
  part("a dt^2 (in v)", 0, [](T s) { return y_and_v(0, s.a() * s.dt * s.dt); });
  part("v without dt (in y)", 0, [](T s) { return y_and_v(s.v, 0); });
  part("a without dt (in v)", 0, [](T s) { return y_and_v(0, s.a()); });
  part("a dt (in y)", 0, [](T s) { return y_and_v(s.a() * s.dt, 0); });
  part("v dt (in v)", 0, [](T s) { return y_and_v(0, s.v * s.dt); });
  const auto other = [&](const char* name, auto a) {  // another acceleration
    part(name, 0, [a](T s) { return y_and_v(a(s) * s.dt * s.dt, a(s) * s.dt); });
  };
  other("the acceleration at t = 0", [](T s) { return s.law(0, s.y, s.v); });
  other("the acceleration at t + dt", [](T s) { return s.law(s.t + s.dt, s.y, s.v); });
  other("the acceleration of the first call (`static`?)", [first](T) { return first.a(); });
  return q;
}

}  // namespace

TEST_SUITE("01_free_fall") {
  TEST_CASE("the force is the weight, downwards") {
    Question<Moment> q;
    q.tested = "the force on the ball";
    q.unit = "N";
    q.names = {"", "F", ""};
    q.lesson = "docs/01_free_fall.md, \"The idea\"";
    q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
    q.truth = [](const Moment& m) { return up(-m.weight()); };
    q.rounding = force_rounding;
    q.where = falling;
    q.when = one_moment;
    q.look_at = "gravity is the only force here: F = -m g, wherever the ball is.";
    q.suspects = {
        {"gravity points up",
         "the size is right and the sign is not. y counts upwards and gravity pulls downwards.",
         [](const Moment& m) { return up(m.weight()); }},
        {"mass forgotten", "this is the acceleration. The force is mass times that: F = -m g.",
         [](const Moment& m) { return up(-m.setting.gravity); }},
        {example_numbers, example_advice, [](const Moment&) { return up(-9.81); }}};
    q.parts = {{"m g", 1, [](const Moment& m) { return up(-m.weight()); }},
               {"g, without the mass", 0, [](const Moment& m) { return up(-m.setting.gravity); }},
               {"the number 9.81, times the mass", 0,
                [](const Moment& m) { return up(-9.81 * m.setting.mass); }},
               {"a constant of 1 N", 0, [](const Moment&) { return up(1); }},
               {"m y (gravity does not depend on the place)", 0,
                [](const Moment& m) { return up(m.setting.mass * m.y()); }}};
    q.factors = {
        {"the mass", [](const Moment& m) { return m.setting.mass; }},
        {"the mass squared", [](const Moment& m) { return m.setting.mass * m.setting.mass; }},
        {"gravity", [](const Moment& m) { return m.setting.gravity; }},
        {"y", [](const Moment& m) { return m.y(); }},
        {"t", [](const Moment& m) { return m.t; }}};
    judge(q, moments());
  }

  TEST_CASE("the acceleration is force / mass") {
    Question<Moment> q;
    q.tested = "the ball's acceleration";
    q.unit = "m/s^2";
    q.names = {"", "a", ""};
    q.lesson = "docs/01_free_fall.md, \"The idea\"";
    q.answer = [](const Moment& m) { return subject().acceleration(m.setting, m.t, m.motion); };
    q.truth = [](const Moment& m) { return up(-m.setting.gravity); };
    q.rounding = [](const Moment&) { return 1e-14 * 20; };  // two roundings of at most 20 m/s^2
    q.where = falling;
    q.when = one_moment;
    q.look_at = "F = m a, read as cause and effect: a = F / m.";
    q.suspects = {{"mass forgotten", "this is the force itself. Divide it by the mass: a = F / m.",
                   [](const Moment& m) { return up(-m.weight()); }},
                  {"multiplied by the mass", "F = m a, so a = F / m: divide.",
                   [](const Moment& m) { return up(-m.weight() * m.setting.mass); }},
                  {example_numbers, example_advice, [](const Moment&) { return up(-9.81); }}};
    q.parts = {
        {"g", 1, [](const Moment& m) { return up(-m.setting.gravity); }},
        {"m g", 0, [](const Moment& m) { return up(-m.weight()); }},
        {"g / m", 0, [](const Moment& m) { return up(-m.setting.gravity / m.setting.mass); }},
        {"1 m/s^2", 0, [](const Moment&) { return up(1); }}};
    judge(q, moments());
  }

  TEST_CASE("one step of the loop: acceleration, then velocity, then position") {
    Dice dice(2);
    std::vector<Turn> turns;
    for (const double dt : {0.1, 0.03, 1e-3}) {
      for (int i = 0; i < 10; ++i) {
        const LinearLaw law{dice.between(-9, 9), dice.between(-5, 5), dice.between(-2, 2),
                            dice.between(-3, 3)};
        turns.push_back({law, dice.between(0, 2), dice.between(-2, 2), dice.between(-2, 2), dt});
      }
    }
    judge(loop_question(turns[0]), turns);
  }

  TEST_CASE("after many steps the position is g t dt / 2 below the formula") {
    struct Fall {
      Setting setting;
      double y0, v0, dt;
      long steps;
      double end() const { return dt * static_cast<double>(steps); }
    };
    Dice dice(3);
    std::vector<Fall> falls;
    for (const double dt : {0.1, 0.03, 0.01, 1e-3}) {
      falls.push_back({any_setting(dice), dice.between(1, 9), dice.between(-3, 3), dt,
                       std::lround(dice.between(0.8, 1.5) / dt)});
    }
    const auto formula = [](const Fall& f, double error) {
      const double g = f.setting.gravity, t = f.end();
      return up(f.y0 + f.v0 * t - g * t * t / 2 + error * g * t * f.dt / 2);
    };
    Question<Fall> q;
    q.tested = "the position after many steps of your loop";
    q.unit = "m";
    q.names = {"", "y", ""};
    q.lesson = "docs/deeper/01_free_fall.md, \"How accurate and how fast\"";
    q.answer = [](const Fall& f) {
      return up(subject().run(f.setting, {up(f.y0), up(f.v0)}, f.dt, f.steps).position[1]);
    };
    // v falls by g dt in each of n steps, so y by g dt^2 (1 + ... + n) = g t^2 / 2 + g t dt / 2.
    q.truth = [=](const Fall& f) { return formula(f, -1); };
    q.rounding = [](const Fall& f) { return 1e-14 * static_cast<double>(f.steps + 10); };
    q.where = [](const Fall& f) {
      return "from y = " + number(f.y0) + " m, v = " + number(f.v0) + " m/s, gravity " +
             number(f.setting.gravity) + ", mass " + number(f.setting.mass);
    };
    q.when = [](const Fall& f) {
      return "t = " + number(f.end()) + " s, dt = " + number(f.dt) + " s";
    };
    q.look_at = "each single step was right. Does your loop remember something between steps?";
    q.suspects = {{"position before velocity", "this is explicit Euler: velocity first.",
                   [=](const Fall& f) { return formula(f, 1); }}};
    judge(q, falls);
  }
}

}  // namespace bounce::check::free_fall
