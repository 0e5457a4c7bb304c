#include <doctest/doctest.h>

#include "checks/run_check.hpp"

using namespace bounce::check;

namespace {

constexpr int relative = 0, fixed_switch = 2;  // FloorLaw; 1 is absolute

double angle(const Moment& m) { return m.setting.angular_frequency * m.t + m.setting.phase; }
double steady(const Moment& m) { return m.setting.floor_velocity * m.t; }
double height(const Moment& m) { return steady(m) + m.setting.amplitude * std::sin(angle(m)); }
double speed(const Moment& m) {
  return m.setting.floor_velocity +
         m.setting.amplitude * m.setting.angular_frequency * std::cos(angle(m));
}

std::string floor_text(const Moment& m) {
  const Setting& s = m.setting;
  return "amplitude " + number(s.amplitude) + ", angular_frequency " + number(s.angular_frequency) +
         ", phase " + number(s.phase) + ", floor_velocity " + number(s.floor_velocity);
}

Question<Moment> floor_question(const std::string& tested, const char* unit, const char* name) {
  Question<Moment> q;
  q.tested = tested;
  q.unit = unit;
  q.names = {"", name, ""};
  q.lesson = "docs/06_oscillating_floor.md, \"The idea\"";
  q.rounding = [](const Moment& m) {
    return 1e-13 * (1 + std::abs(steady(m)) + m.setting.amplitude * m.setting.angular_frequency);
  };
  q.where = floor_text;
  q.when = one_moment;
  return q;
}

/// What a force would be, if floor and contact were so.
struct View {
  double floor, floor_speed;  // as the code sees them
  bool moving_contact = true;
  bool relative_damper = true;
};

Triple force_with(const Moment& m, const View& view) {
  const Setting& s = m.setting;
  const double contact_floor = view.moving_contact ? view.floor : 0;
  if (!(m.y() - contact_floor < s.radius)) return up(-m.weight());
  const double v = view.relative_damper ? m.v() - view.floor_speed : m.v();
  return up(-m.weight() + push(s, s.radius - m.y() + view.floor, v));
}
View seen(const Moment& m) {
  return {height(m), speed(m), m.setting.floor_law != fixed_switch,
          m.setting.floor_law == relative};
}
Triple right(const Moment& m) { return force_with(m, seen(m)); }

Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q = floor_question(tested, "N", "F");
  q.lesson = "docs/06_oscillating_floor.md, \"The program\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = right;
  q.rounding = force_rounding;
  q.where = [](const Moment& m) {
    static const char* laws[] = {"relative", "absolute", "fixed-switch"};
    return on_a_line(m) + "; " + floor_text(m) + ", floor_law " + laws[m.setting.floor_law] +
           "; the floor is at " + number(height(m)) + " m and moves with " + number(speed(m)) +
           " m/s";
  };
  q.look_at = "the overlap is r - y + floor height; the damper sees v - floor speed.";
  const auto view = [](auto change) {
    return [change](const Moment& m) {
      View v = seen(m);
      change(m, v);
      return force_with(m, v);
    };
  };
  q.suspects = {
      {"gravity points up", "y counts upwards, gravity pulls downwards.",
       [](const Moment& m) { return plus(right(m), up(2 * m.weight())); }},
      {"mass forgotten", "a force is wanted, and gravity alone is an acceleration.",
       [](const Moment& m) { return plus(right(m), up(m.weight() - m.setting.gravity)); }},
      {"contact tested at y < r on a moving floor",
       "the ball touches where the floor *is*: while y - floor < r.",
       view([](const Moment&, View& v) { v.moving_contact = false; })},
      {"damper with absolute velocity",
       "the damper brakes the ball's own velocity. With floor_law relative it brakes the velocity "
       "between ball and floor: v - floor speed.",
       view([](const Moment&, View& v) { v.relative_damper = false; })},
      {"the floor's sign",
       "a floor that rises presses the ball more: the overlap is r - y + floor height.",
       [](const Moment& m) {
         const Setting& s = m.setting;
         if (!(m.y() - height(m) < s.radius)) return up(-m.weight());
         return up(-m.weight() + push(s, s.radius - m.y() - height(m), m.v() - speed(m)));
       }},
      {"the floor's sign",
       "the floor is on the wrong side in yours: y - floor < r, and r - y + floor.",
       view([](const Moment&, View& v) { v.floor = -v.floor; })},
      {"the floor's speed with the wrong sign", "the damper sees v *minus* the floor's speed.",
       view([](const Moment&, View& v) { v.floor_speed = -v.floor_speed; })},
      {"a floor at rest", "the floor is at height 0 in yours. Ask floor_height(t).",
       view([](const Moment&, View& v) { v.floor = v.floor_speed = 0; })},
      {"the damper has the wrong sign", "a brake points against the velocity.",
       [](const Moment& m) {
         Moment other = m;
         other.setting.damping = -m.setting.damping;
         return right(other);
       }},
      {"push_only forgotten", "with contact push_only the push is max(0, spring + damper).",
       [](const Moment& m) {
         Moment other = m;
         other.setting.push_only = false;
         return right(other);
       }},
      {"push_only whatever the contact", "only if contact == ContactLaw::push_only.",
       [](const Moment& m) {
         Moment other = m;
         other.setting.push_only = true;
         return right(other);
       }}};
  return q;
}

enum Kind { only_relative, all_laws, switch_law };

std::vector<Moment> moments(unsigned seed, double least, double most, Kind kind) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 30; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.amplitude = dice.between(0.05, 0.3);
    s.angular_frequency = dice.between(3, 30);
    s.phase = dice.between(0, 6);
    s.floor_velocity = dice.between(-0.5, 0.5);
    if (kind == all_laws) {
      s.floor_law = i % 3;
      s.push_only = i % 2 == 1;
    }
    if (kind == switch_law) s.floor_law = fixed_switch;
    Moment m{s, dice.between(0, 3), {{}, up(dice.between(-5, 5))}};
    const double from = kind == switch_law ? 0 : height(m);
    m.motion.position = up(from + s.radius * (1 - dice.between(least, most)));
    all.push_back(m);
  }
  return all;
}

}  // namespace

TEST_SUITE("06_oscillating_floor") {
  TEST_CASE("the floor is at floor_velocity t + A sin(w t + phase)") {
    Question<Moment> q = floor_question("floor_height(t)", "m", "height");
    q.answer = [](const Moment& m) { return up(subject().floor_height(m.setting, m.t)); };
    q.truth = [](const Moment& m) { return up(height(m)); };
    q.look_at = "h(t) = floor_velocity t + A sin(w t + phase)";
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
  TEST_CASE("floor_law fixed-switch: in contact while y < r, wherever the floor is") {
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
