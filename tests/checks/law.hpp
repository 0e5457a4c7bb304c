#pragma once
#include <algorithm>
#include <string>

#include "checks/judge.hpp"
#include "physics/text.hpp"

namespace bounce::check {

// The plain second implementation that the stages are compared with: scalars, loops, no Eigen.

inline Triple plus(const Triple& a, const Triple& b, double factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Triple times(double factor, const Triple& a) { return plus({}, a, factor); }
inline double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Triple& a) { return std::sqrt(dot(a, a)); }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What spring and damper push with [N], for an overlap and a velocity away from the floor.
inline double push(const Setting& s, double overlap, double away) {
  const double both = s.stiffness * overlap - s.damping * away;
  return s.push_only ? std::max(0.0, both) : both;
}

/// One question about one ball: a force or an acceleration, here and now.
struct Moment {
  Setting setting;
  double t;
  Motion motion;

  double y() const { return motion.position[1]; }
  double v() const { return motion.velocity[1]; }
  bool overlaps() const { return y() < setting.radius; }
  double weight() const { return setting.mass * setting.gravity; }
};

inline Triple up(double y) { return {0, y, 0}; }

/// A setting that is nobody's example.
inline Setting any_setting(Dice& dice) {
  Setting s;
  s.mass = dice.between(0.3, 4);
  s.gravity = dice.between(2, 20);
  s.radius = dice.between(0.05, 0.3);
  s.stiffness = std::pow(10, dice.between(3, 5));
  return s;
}

/// The sum of what can be rounded in a force, a few times: 1e-16 each; formulas may be ordered
/// differently.
inline double force_rounding(const Moment& m) {
  const Setting& s = m.setting;
  const double size = std::abs(m.motion.position[0]) + std::abs(m.y()) +
                      std::abs(m.motion.position[2]) + s.radius + s.amplitude +
                      std::abs(s.floor_velocity * m.t) + std::abs(s.offset);
  return 1e-13 * (m.weight() + s.stiffness * size +
                  s.damping * (length(m.motion.velocity) + s.amplitude * s.angular_frequency));
}

inline std::string number(double value) { return to_rounded_text(value, 5); }
inline std::string numbers(const Triple& t) {
  return "(" + number(t[0]) + ", " + number(t[1]) + ", " + number(t[2]) + ")";
}

/// For the reader: where the ball is, in one dimension.
inline std::string on_a_line(const Moment& m) {
  const Setting& s = m.setting;
  return "y = " + number(m.y()) + " m, v = " + number(m.v()) + " m/s; mass " + number(s.mass) +
         ", gravity " + number(s.gravity) + ", radius " + number(s.radius) + ", stiffness " +
         number(s.stiffness) + (s.damping != 0 ? ", damping " + number(s.damping) : "") +
         (s.push_only ? ", contact push_only" : "");
}
inline std::string in_space(const Moment& m) {
  const Setting& s = m.setting;
  return "position " + numbers(m.motion.position) + " m, velocity " + numbers(m.motion.velocity) +
         " m/s; mass " + number(s.mass) + ", gravity " + number(s.gravity) + ", radius " +
         number(s.radius) + ", stiffness " + number(s.stiffness) + ", damping " +
         number(s.damping) + (s.push_only ? ", contact push_only" : "");
}
inline std::string one_moment(const Moment& m) {
  return "t = " + number(m.t) + " s; a single evaluation, so no dt";
}

/// The same moment in the numbers of the lesson's example.
inline Moment as_in_the_example(Moment m) {
  const double damping = m.setting.damping;
  m.setting.mass = 1;
  m.setting.gravity = 9.81;
  m.setting.radius = 0.1;
  m.setting.stiffness = 1e4;
  if (damping != 0) m.setting.damping = 5;
  return m;
}

inline constexpr const char* example_numbers = "the example's numbers";
inline constexpr const char* example_advice =
    "your answers fit mass 1, gravity 9.81 and the other numbers of the example only. Write the "
    "names (mass, gravity, ...) in place of the numbers.";

}  // namespace bounce::check
