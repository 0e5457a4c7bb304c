#include "checks/06_oscillating_floor_questions.hpp"

#include <doctest/doctest.h>

namespace bounce::check::oscillating_floor {

TEST_SUITE("06_oscillating_floor") {
  TEST_CASE("the floor is at floor_velocity t + A sin(w t + phase)") {
    Question<Moment> q = floor_question("floor_height(t)", "m", "height");
    q.answer = [](const Moment& m) { return up(subject().floor_height(m.setting, m.t)); };
    q.truth = [](const Moment& m) { return up(height(m)); };
    q.look_at = "h(t) = floor_velocity t + A sin(w t + phase)";
    q.factors = {{"t", [](const Moment& m) { return m.t; }},
                 {"w", [](const Moment& m) { return m.setting.angular_frequency; }},
                 {"A", [](const Moment& m) { return m.setting.amplitude; }}};
    using M = const Moment&;
    const auto part = [&](const char* name, double wanted, auto value) {
      q.parts.push_back({name, wanted, [=](M m) { return up(value(m)); }});
    };
    const auto swing = [&](const char* name, auto at) {
      part(name, 0, [=](M m) { return m.setting.amplitude * std::sin(at(m)); });
    };
    part("floor_velocity t", 1, steady);
    part("A sin(w t + phase)", 1, [](M m) { return height(m) - steady(m); });
    part("floor_velocity, without t,", 0, [](M m) { return m.setting.floor_velocity; });
    part("A cos(w t + phase)", 0, [](M m) { return m.setting.amplitude * std::cos(angle(m)); });
    part("sin(w t + phase) without A", 0, [](M m) { return std::sin(angle(m)); });
    swing("A sin(w t - phase)", [](M m) { return angle(m) - 2 * m.setting.phase; });
    swing("A sin(w t)", [](M m) { return angle(m) - m.setting.phase; });
    swing("A sin(w (t + phase))",
          [](M m) { return m.setting.angular_frequency * (m.t + m.setting.phase); });
    swing("A sin(2 pi w t + phase)", [](M m) {
      return 2 * std::acos(-1) * m.setting.angular_frequency * m.t + m.setting.phase;
    });
    swing("A sin of the angle in degrees", [](M m) { return angle(m) * std::acos(-1) / 180; });
    swing("A sin(t + phase), without w,", [](M m) { return m.t + m.setting.phase; });
    q.suspects = {
        {"cos instead of sin", "the floor starts in the middle of its swing: sin, not cos.",
         [](const Moment& m) { return up(steady(m) + m.setting.amplitude * std::cos(angle(m))); }},
        {"the floor's sign", "the size is right; which way does the floor start?",
         [](const Moment& m) { return up(-height(m)); }},
        {"the floor's sign", "the swing has the wrong sign.",
         [](const Moment& m) { return up(2 * steady(m) - height(m)); }},
        {"phase forgotten", "the swing starts at the angle `phase`: sin(w t + phase).",
         [](const Moment& m) {
           return up(steady(m) + m.setting.amplitude * std::sin(angle(m) - m.setting.phase));
         }},
        {"floor_velocity forgotten", "the floor may also move steadily: floor_velocity * t.",
         [](const Moment& m) { return up(height(m) - steady(m)); }}};
    judge(q, moments(61, -1, 1, only_relative));
  }
  TEST_CASE("the floor's speed is the derivative of its height") {
    Question<Moment> q = floor_question("floor_speed(t)", "m/s", "speed");
    q.answer = [](const Moment& m) { return up(subject().floor_speed(m.setting, m.t)); };
    q.truth = [](const Moment& m) { return up(speed(m)); };
    q.look_at = "differentiate floor_velocity t + A sin(w t + phase).";
    q.factors = {{"t", [](const Moment& m) { return m.t; }},
                 {"w", [](const Moment& m) { return m.setting.angular_frequency; }},
                 {"A", [](const Moment& m) { return m.setting.amplitude; }}};
    using M = const Moment&;
    const auto part = [&](const char* name, double wanted, auto value) {
      q.parts.push_back({name, wanted, [=](M m) { return up(value(m)); }});
    };
    const auto wave = [](M m) { return std::cos(angle(m)); };
    part("floor_velocity", 1, [](M m) { return m.setting.floor_velocity; });
    part("A w cos(w t + phase)", 1, [](M m) { return speed(m) - m.setting.floor_velocity; });
    part("w cos(w t + phase) without A", 0,
         [=](M m) { return m.setting.angular_frequency * wave(m); });
    part("A cos(w t + phase) without w", 0, [=](M m) { return m.setting.amplitude * wave(m); });
    part("A w sin(w t + phase)", 0, [](M m) {
      return m.setting.amplitude * m.setting.angular_frequency * std::sin(angle(m));
    });
    part("A w cos(w t) without phase", 0, [](M m) {
      return m.setting.amplitude * m.setting.angular_frequency *
             std::cos(angle(m) - m.setting.phase);
    });
    part("floor_velocity t", 0, steady);
    q.suspects = {
        {"w forgotten", "the derivative of sin(w t) is w cos(w t): the inner derivative counts.",
         [](const Moment& m) {
           return up(m.setting.floor_velocity + m.setting.amplitude * std::cos(angle(m)));
         }},
        {"sin for cos", "the derivative of sin is cos.",
         [](const Moment& m) {
           return up(m.setting.floor_velocity +
                     m.setting.amplitude * m.setting.angular_frequency * std::sin(angle(m)));
         }},
        {"floor_velocity forgotten", "the derivative of floor_velocity t is floor_velocity.",
         [](const Moment& m) { return up(speed(m) - m.setting.floor_velocity); }}};
    judge(q, moments(62, -1, 1, only_relative));
  }
  TEST_CASE("the laws: touches(y, floor) and damped_velocity(t, v)") {
    Question<Moment> q = floor_question("touches(y, floor)", "", "touches");
    q.lesson = "docs/06_oscillating_floor.md, \"The idea\"";
    q.look_at = "the table above the gap: one row for each floor_law.";
    q.where = [](const Moment& m) {
      return "y = " + number(m.y()) + " m, v = " + number(m.v()) + " m/s, radius " +
             number(m.setting.radius) + "; " + law_name(m) + "; the floor is at " +
             number(height(m)) + " m and moves with " + number(speed(m)) + " m/s";
    };
    q.place = [](const Moment& m) { return "with " + law_name(m); };
    q.answer = [](const Moment& m) {
      return up(subject().touches(m.setting, m.y(), height(m)) ? 1 : 0);
    };
    const auto moving = [](const Moment& m) {
      return up(m.y() - height(m) < m.setting.radius ? 1 : 0);
    };
    const auto fixed = [](const Moment& m) { return up(m.y() < m.setting.radius ? 1 : 0); };
    q.truth = [=](const Moment& m) {
      return m.setting.floor_law == fixed_switch ? fixed(m) : moving(m);
    };
    q.suspects = {{"contact tested at y < r on a moving floor",
                   "the ball touches where the floor *is*: while y - floor < r.", fixed},
                  {"the floor's sign", "the floor is on the wrong side in yours: y - floor < r.",
                   [](const Moment& m) {
                     const double floor = m.setting.floor_law == fixed_switch ? 0 : -height(m);
                     return up(m.y() - floor < m.setting.radius ? 1 : 0);
                   }}};
    judge(q, moments(69, -1, 1, all_laws));
    q.tested = "damped_velocity(t, v)";
    q.unit = "m/s";
    q.names = {"", "velocity", ""};
    q.answer = [](const Moment& m) { return up(subject().damped_velocity(m.setting, m.t, m.v())); };
    q.truth = [](const Moment& m) {
      return up(m.v() - (m.setting.floor_law == relative ? speed(m) : 0));
    };
    q.parts = {
        {"v", 1, [](const Moment& m) { return up(m.v()); }},
        {"- the floor's speed", 1,
         [](const Moment& m) { return up(m.setting.floor_law == relative ? -speed(m) : 0); }},
        {"the floor's speed where it does not count", 0,
         [](const Moment& m) { return up(m.setting.floor_law == relative ? 0 : speed(m)); }}};
    q.suspects = {
        {"damper with absolute velocity",
         "the damper brakes the ball's own velocity. With floor_law relative it brakes "
         "the velocity between ball and floor: v - floor speed.",
         [](const Moment& m) { return up(m.v()); }},
        {"relative whatever the law", "only with floor_law relative does the floor's speed count.",
         [](const Moment& m) { return up(m.v() - speed(m)); }},
        {"the floor's speed is added",
         "with floor_law relative the damper sees v *minus* the floor's speed, and else v alone.",
         [](const Moment& m) { return up(m.v() + speed(m)); }},
        {"the floor's speed with the wrong sign", "the damper sees v *minus* the floor's speed.",
         [](const Moment& m) {
           return up(m.v() + (m.setting.floor_law == relative ? speed(m) : 0));
         }}};
    judge(q, moments(70, -1, 1, all_laws));
  }
  TEST_CASE("above the moving floor only gravity acts") {
    judge(force_question("the force on a ball that does not touch"),
          moments(63, -3, -0.01, only_relative));
  }
  TEST_CASE("in contact: k (r - y + floor) - c (v - floor speed)") {
    judge(force_question("the force on a ball that overlaps the floor"),
          moments(64, 0.01, 3, only_relative));
  }
  TEST_CASE("all three floor laws, with both kinds of contact") {
    judge(force_question("the force on a ball"), moments(65, -0.5, 0.7, all_laws));
  }
  TEST_CASE("floor_law fixed_switch: in contact while y < r, wherever the floor is") {
    judge(force_question("the force on a ball"), moments(66, -0.5, 0.7, switch_law));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(67, 0, 0, only_relative);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      Moment& m = edge[i];
      // Numbers that add up without rounding: the floor at rest at 1/4 m, or the slides' switch.
      m.setting.radius = 0.5;
      m.setting.amplitude = 0;
      m.setting.floor_velocity = 0.25;
      m.t = 1;
      m.setting.floor_law = i % 2 == 0 ? relative : fixed_switch;
      m.motion.position = up(i % 2 == 0 ? 0.75 : 0.5);
    }
    judge(force_question("the force on a ball exactly at the touch"), edge);
  }
  TEST_CASE("the ball bounces on the swinging floor as the exact solution says, for several dt") {
    Dice dice(68);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
      s.amplitude = dice.between(0.02, 0.06);
      s.angular_frequency = dice.between(5, 15);
      s.phase = dice.between(0, 6);
      runs.push_back(floor_run(s, dice.between(0.3, 1), dt));
    }
    judge_runs("docs/06_oscillating_floor.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::oscillating_floor
