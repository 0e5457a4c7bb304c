#pragma once
#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

// The questions about a plane, and what learners get wrong there.

namespace bounce::check::tilted_plane {

struct Equation {  // n . p + d = 0, with whatever length n has
  Triple n;
  double d;
  double distance(const Triple& p) const { return dot(n, p) + d; }
};

inline Equation as_given(const Moment& m) { return {m.setting.normal, m.setting.offset}; }
inline Equation unit(const Moment& m) {
  const double size = length(m.setting.normal);
  return {times(1 / size, m.setting.normal), m.setting.offset / size};
}

inline Triple force_on(const Moment& m, double y, double v, const Triple& along) {
  const double p = y < m.setting.radius ? push(m.setting, m.setting.radius - y, v) : 0;
  return plus(up(-m.weight()), along, p);
}
inline Triple force_of(const Moment& m, const Equation& plane) {
  return force_on(m, plane.distance(m.motion.position), dot(plane.n, m.motion.velocity), plane.n);
}
inline Triple right(const Moment& m) { return force_of(m, unit(m)); }

inline std::string plane_text(const Moment& m) {
  return "normal " + numbers(m.setting.normal) + ", offset " + number(m.setting.offset);
}

inline Question<Moment> plane_question() {
  Question<Moment> q;
  q.lesson = "docs/07_tilted_plane.md, \"The idea\"";
  q.rounding = [](const Moment& m) { return 1e-14 * (1 + std::abs(m.setting.offset)); };
  q.where = plane_text;
  q.when = one_moment;
  return q;
}

inline Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q = plane_question();
  q.tested = tested;
  q.unit = "N";
  q.names = {"Fx", "Fy", "Fz"};
  q.lesson = "docs/07_tilted_plane.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = right;
  q.rounding = [](const Moment& m) { return 4 * force_rounding(m); };
  q.where = [](const Moment& m) { return in_space(m) + "; " + plane_text(m); };
  q.look_at = "distance n . p + d, velocity away n . v, and a push along n.";
  const auto contact = [](const Moment& m) {
    const Equation plane = unit(m);
    const double overlap = m.setting.radius - plane.distance(m.motion.position);
    return Contact{plane.n, overlap, dot(plane.n, m.motion.velocity), overlap > 0};
  };
  q.place = [=](const Moment& m) { return contact_place(contact(m), m.setting.radius); };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself);
  q.factors = force_factors<Moment>(contact, itself);
  q.suspects = {
      {"gravity points up", "y is up and gravity pulls downwards.",
       [](const Moment& m) { return plus(right(m), up(2 * m.weight())); }},
      {"mass forgotten", "a force is wanted, and gravity alone is an acceleration.",
       [](const Moment& m) { return plus(right(m), up(m.weight() - m.setting.gravity)); }},
      {"gravity along the normal", "gravity pulls straight down, whatever the plane does.",
       [](const Moment& m) {
         return plus(plus(right(m), up(m.weight())), unit(m).n, -m.weight());
       }},
      {"normal not normalised",
       "the equation's normal has any length. Divide normal and offset by it first: use plane().",
       [](const Moment& m) { return force_of(m, as_given(m)); }},
      {"the offset's sign", "the distance is n . p + d: plus.",
       [](const Moment& m) {
         Equation plane = unit(m);
         plane.d = -plane.d;
         return force_of(m, plane);
       }},
      {"the offset forgotten", "the distance is n . p + d. Without d every plane goes through 0.",
       [](const Moment& m) {
         Equation plane = unit(m);
         plane.d = 0;
         return force_of(m, plane);
       }},
      {"distance without sign",
       "behind the plane the distance is negative, and so the overlap is more than the radius. "
       "With "
       "|n . p + d| a ball that got too deep is let through, or pulled in.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         return force_on(m, std::abs(plane.distance(m.motion.position)),
                         dot(plane.n, m.motion.velocity), plane.n);
       }},
      {"the push along y", "a tilted floor pushes along its normal, not straight up.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         return force_on(m, plane.distance(m.motion.position), dot(plane.n, m.motion.velocity),
                         up(1));
       }},
      {"the damper sees the velocity along y", "the velocity away from the plane is n . v.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         return force_on(m, plane.distance(m.motion.position), m.motion.velocity[1], plane.n);
       }},
      {"the damper has the wrong sign", "a brake points against the velocity: - c n . v.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         return force_on(m, plane.distance(m.motion.position), -dot(plane.n, m.motion.velocity),
                         plane.n);
       }},
      {"damper on all three components",
       "the plane is frictionless: only the part of the velocity along the normal is braked.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         const double overlap = m.setting.radius - plane.distance(m.motion.position);
         if (!(overlap > 0)) return up(-m.weight());
         return plus(plus(up(-m.weight()), plane.n, m.setting.stiffness * overlap),
                     m.motion.velocity, -m.setting.damping);
       }},
      {"the normal points the other way", "the ball is pushed to the side where the normal points.",
       [](const Moment& m) {
         const Equation plane = unit(m);
         return force_on(m, plane.distance(m.motion.position), dot(plane.n, m.motion.velocity),
                         times(-1, plane.n));
       }},
      {"push_only forgotten", "with contact push_only the push is std::max(0.0, spring + damper).",
       [](const Moment& m) {
         Moment other = m;
         other.setting.push_only = false;
         return right(other);
       }}};
  const auto limited = limits_the_weight(contact);
  q.suspects.insert(q.suspects.end(), limited.begin(), limited.end());
  return q;
}

/// `least` and `most`: the distance from the plane, in radii.
inline std::vector<Moment> moments(unsigned seed, double least, double most, bool push_only_too) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 30; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.push_only = push_only_too && i % 2 == 1;
    const Triple direction = dice.direction();
    s.normal = times(dice.between(0.3, 4), direction);
    s.offset = dice.sign() * dice.between(0.2, 3);
    Moment m{s, dice.between(0, 3), {dice.triple(2), dice.triple(9)}};
    const Equation plane = unit(m);
    const bool deep = i % 4 == 3 && least < 0;  // the whole ball is behind the plane
    const double wanted = s.radius * dice.between(deep ? -40 : least, most);
    m.motion.position =
        plus(m.motion.position, plane.n, wanted - plane.distance(m.motion.position));
    all.push_back(m);
  }
  return all;
}

}  // namespace bounce::check::tilted_plane
