#pragma once
#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

// The questions about two balls and about many, and what learners get wrong there.

namespace bounce::check::ball_collision {

/// Two balls, and the contact between them.
struct Two {
  Setting setting;
  OneOfMany one, two;
  Triple between() const { return plus(one.motion.position, two.motion.position, -1); }
  double d() const { return length(between()); }
  double overlap() const { return one.radius + two.radius - d(); }
  Triple e12() const {  // from ball 2 to ball 1; where they coincide, up
    return d() > 0 ? times(1 / d(), between()) : up(1);
  }
  Triple slip() const { return plus(one.motion.velocity, two.motion.velocity, -1); }
  double separation() const { return dot(slip(), e12()); }
};

inline Contact contact_of(const Two& p) {
  return {p.e12(), p.overlap(), p.separation(), p.overlap() > 0};
}
inline std::string pair_place(const Two& p) {
  if (p.overlap() <= 0) return "without contact";
  if (p.d() == 0) return "where the centres coincide";
  if (p.d() < std::max(p.one.radius, p.two.radius)) return "with one centre inside the other ball";
  return p.separation() < 0 ? "while they approach" : "while they part";
}

inline std::string two_text(const Two& p) {
  return "ball 1 at " + numbers(p.one.motion.position) + " m with " +
         numbers(p.one.motion.velocity) + " m/s, radius " + number(p.one.radius) + "; ball 2 at " +
         numbers(p.two.motion.position) + " m with " + numbers(p.two.motion.velocity) +
         " m/s, radius " + number(p.two.radius) + "; stiffness " + number(p.setting.stiffness) +
         ", damping " + number(p.setting.damping);
}

inline Question<Two> question(const std::string& tested, const std::string& unit) {
  Question<Two> q;
  q.tested = tested;
  q.unit = unit;
  q.names = {"x", "y", "z"};
  q.lesson = "docs/05_ball_collision.md, \"The idea\"";
  q.rounding = [](const Two&) { return 1e-13; };  // metres, m/s and unit vectors
  q.where = two_text;
  q.when = [](const Two&) { return std::string("one moment; a single evaluation, so no dt"); };
  q.place = pair_place;
  return q;
}

/// Pairs whose overlap is between `least` and `most` metres.
inline std::vector<Two> pairs(unsigned seed, double least, double most,
                              bool push_only_too = false) {
  Dice dice(seed);
  std::vector<Two> all;
  for (int i = 0; i < 30; ++i) {
    Two p{any_setting(dice), {}, {}};
    p.setting.damping = dice.between(1, 300);
    p.setting.push_only = push_only_too && i % 2 == 1;
    p.one = {{dice.triple(2), dice.triple(5)}, dice.between(0.1, 0.3), dice.between(0.5, 3)};
    p.two = {{{}, dice.triple(5)}, dice.between(0.1, 0.3), dice.between(0.5, 3)};
    const double both = p.one.radius + p.two.radius;
    double d = both - dice.between(least, most);
    if (least > 0 && i % 4 == 3) d = both * dice.between(0.02, 0.5);  // deep in each other
    p.two.motion.position = plus(p.one.motion.position, dice.direction(), d);
    all.push_back(p);
  }
  return all;
}

inline Triple force_along(const Two& p, double overlap, double separation, const Triple& e) {
  return overlap > 0 ? times(push(p.setting, overlap, separation), e) : Triple{};
}
inline Triple right(const Two& p) { return force_along(p, p.overlap(), p.separation(), p.e12()); }

inline Question<Two> force_question() {
  Question<Two> q = question("the force on ball 1", "N");
  q.names = {"Fx", "Fy", "Fz"};
  q.answer = [](const Two& p) { return subject().pair_force(p.setting, p.one, p.two); };
  q.truth = right;
  q.rounding = [](const Two& p) { return 1e-12 * (p.setting.stiffness + 10 * p.setting.damping); };
  q.look_at = "spring and damper of stage 3, from overlap and separation speed, along e12.";
  q.place = pair_place;
  const auto moment = [](const Two& p) {
    Setting s = p.setting;
    s.gravity = 0;  // not asked here
    return Moment{s, 0, {{}, p.slip()}};
  };
  q.parts = force_parts<Two>(contact_of, moment);
  q.factors = force_factors<Two>(contact_of, moment);
  q.suspects = {
      {"the force on ball 2",
       "the force on ball 1 is along +e12: it pushes ball 1 away from ball 2.",
       [](const Two& p) { return times(-1, right(p)); }},
      {"the damper has the wrong sign", "a brake acts against the separation speed.",
       [](const Two& p) { return force_along(p, p.overlap(), -p.separation(), p.e12()); }},
      {"no damper", "the contact has a damper, too: it needs the separation speed.",
       [](const Two& p) { return force_along(p, p.overlap(), 0, p.e12()); }},
      {"pushing where nothing touches", "without overlap there is no force.",
       [](const Two& p) { return times(push(p.setting, p.overlap(), p.separation()), p.e12()); }}};
  return q;
}

}  // namespace bounce::check::ball_collision
