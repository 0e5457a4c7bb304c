#pragma once
#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

// The questions about a floor that moves, and what learners get wrong there.

namespace bounce::check::oscillating_floor {

constexpr int relative = 0, fixed_switch = 2;  // FloorLaw; 1 is absolute

inline double angle(const Moment& m) { return m.setting.angular_frequency * m.t + m.setting.phase; }
inline double steady(const Moment& m) { return m.setting.floor_velocity * m.t; }
inline double height(const Moment& m) {
  return steady(m) + m.setting.amplitude * std::sin(angle(m));
}
inline double speed(const Moment& m) {
  return m.setting.floor_velocity +
         m.setting.amplitude * m.setting.angular_frequency * std::cos(angle(m));
}

inline std::string law_name(const Moment& m) {
  static const char* laws[] = {"relative", "absolute", "fixed_switch"};
  return std::string("floor_law ") + laws[m.setting.floor_law];
}

inline std::string floor_text(const Moment& m) {
  const Setting& s = m.setting;
  return "amplitude " + number(s.amplitude) + ", angular_frequency " + number(s.angular_frequency) +
         ", phase " + number(s.phase) + ", floor_velocity " + number(s.floor_velocity);
}

inline Question<Moment> floor_question(const std::string& tested, const char* unit,
                                       const char* name) {
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

inline Triple force_with(const Moment& m, const View& view) {
  const Setting& s = m.setting;
  const double contact_floor = view.moving_contact ? view.floor : 0;
  if (!(m.y() - contact_floor < s.radius)) return up(-m.weight());
  const double v = view.relative_damper ? m.v() - view.floor_speed : m.v();
  return up(-m.weight() + push(s, s.radius - m.y() + view.floor, v));
}
inline View seen(const Moment& m) {
  return {height(m), speed(m), m.setting.floor_law != fixed_switch,
          m.setting.floor_law == relative};
}
inline Triple right(const Moment& m) { return force_with(m, seen(m)); }

inline Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q = floor_question(tested, "N", "F");
  q.lesson = "docs/06_oscillating_floor.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = right;
  q.rounding = force_rounding;
  q.where = [](const Moment& m) {
    return on_a_line(m) + "; " + floor_text(m) + ", " + law_name(m) + "; the floor is at " +
           number(height(m)) + " m and moves with " + number(speed(m)) + " m/s";
  };
  q.look_at =
      "as in stage 3, with touches(y, floor), the overlap r - y + floor height, and "
      "damped_velocity(t, v) for v.";
  const auto contact = [](const Moment& m) {
    const View v = seen(m);
    const double floor = v.moving_contact ? v.floor : 0;
    return Contact{up(1), m.setting.radius - m.y() + v.floor,
                   m.v() - (v.relative_damper ? v.floor_speed : 0),
                   m.y() - floor < m.setting.radius};
  };
  q.place = [=](const Moment& m) {
    static const char* laws[] = {"", ", with floor_law absolute", ", with floor_law fixed_switch"};
    Contact c = contact(m);
    if (m.setting.floor_law == fixed_switch) c.overlap = m.setting.radius - m.y();
    return contact_place(c, m.setting.radius) + laws[m.setting.floor_law];
  };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself, true);
  q.factors = force_factors<Moment>(contact, itself);
  const auto in_contact = [&](const char* name, auto size) {
    q.parts.push_back(
        {name, 0, [=](const Moment& m) { return up(contact(m).touches ? size(m) : 0); }});
  };
  in_contact("k times the floor's height",
             [](const Moment& m) { return m.setting.stiffness * height(m); });
  q.parts.back().inside = true;
  in_contact("c times the floor's speed",
             [](const Moment& m) { return m.setting.damping * speed(m); });
  q.parts.back().inside = true;
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
      {"the floor's height forgotten in the overlap",
       "the overlap is measured from where the floor is: r - y + floor height.",
       [](const Moment& m) {
         const View v = seen(m);
         const double slip = m.v() - (v.relative_damper ? v.floor_speed : 0);
         const bool touches = m.y() - (v.moving_contact ? v.floor : 0) < m.setting.radius;
         const double overlap = m.setting.radius - m.y();
         return up(-m.weight() + (touches ? push(m.setting, overlap, slip) : 0));
       }},
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
      {"push_only forgotten", "with contact push_only the push is std::max(0.0, spring + damper).",
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
  const auto limited = limits_the_weight(contact);
  q.suspects.insert(q.suspects.end(), limited.begin(), limited.end());
  return q;
}

enum Kind { only_relative, all_laws, switch_law };

inline std::vector<Moment> moments(unsigned seed, double least, double most, Kind kind) {
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
    const bool deep = i % 5 == 3 && kind == only_relative && least > 0;  // far below the floor
    m.motion.position = up(from + s.radius * (1 - dice.between(least, deep ? 40 : most)));
    all.push_back(m);
  }
  return all;
}

}  // namespace bounce::check::oscillating_floor
