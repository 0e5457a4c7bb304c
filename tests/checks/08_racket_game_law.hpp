#pragma once
#include <cmath>
#include <string>

#include "checks/law.hpp"

// A second, plain implementation of the racket, with the ways in which it can be got wrong, and
// balls near it.

namespace bounce::check::racket_game {

/// The racket at the moment's time: moved and turned (Rodrigues' formula).
struct Now {
  Triple centre, normal;
};
inline Now racket_at(const Moment& m) {
  const Setting& s = m.setting;
  const double speed = length(s.disc_spin);
  const double later = m.t - s.since;
  Now now{plus(s.centre, s.disc_velocity, later), s.disc_normal};
  if (speed == 0) return now;
  const Triple axis = times(1 / speed, s.disc_spin), &n = s.disc_normal;
  const double c = std::cos(speed * later), d = std::sin(speed * later);
  now.normal = plus(plus(times(c, n), cross(axis, n), d), axis, dot(axis, n) * (1 - c));
  return now;
}

enum class Shape {
  disc,
  rim_included,
  larger,
  small_test,  // the ball's radius for the disc's
  small_rim,
  small,
  infinite,
  square,
  no_rim,
  flat_rim,
  one_sided,
  // beside the disc only:
  reversed,
  side_at_rim,
  normal_at_rim,
  by_height,
  by_height_times_side,
  no_centre
};

inline NearestFound nearest_of(const Setting& s, const Now& now, const Triple& ball, Shape shape) {
  const Triple way = plus(ball, now.centre, -1);
  const double height = dot(now.normal, way);
  const Triple outwards = plus(way, now.normal, -height);
  const double lateral = length(outwards);
  const double side = shape == Shape::one_sided ? 1 : s.side;
  bool over = lateral < s.disc_radius;
  if (shape == Shape::rim_included) over = lateral <= s.disc_radius;
  if (shape == Shape::larger) over = lateral < s.disc_radius + s.radius;
  if (shape == Shape::small_test || shape == Shape::small) over = lateral < s.radius;
  if (shape == Shape::infinite) over = true;
  if (shape == Shape::square) {
    over = std::abs(outwards[0]) < s.disc_radius && std::abs(outwards[2]) < s.disc_radius;
  }
  if (over) return {plus(now.centre, outwards), times(side, now.normal), side * height};
  if (shape == Shape::no_rim) return {plus(now.centre, outwards), times(side, now.normal), 1e30};
  const Triple from = shape == Shape::no_centre ? Triple{} : now.centre;
  const bool is_small = shape == Shape::small_rim || shape == Shape::small;
  const Triple rim = plus(from, outwards, (is_small ? s.radius : s.disc_radius) / lateral);
  if (shape == Shape::flat_rim) return {rim, times(side, now.normal), side * height};
  const Triple out = plus(ball, rim, -1);
  const double distance = length(out);
  if (shape == Shape::reversed) return {rim, times(-1 / distance, out), distance};
  if (shape == Shape::side_at_rim) return {rim, times(side / distance, out), side * distance};
  if (shape == Shape::normal_at_rim) return {rim, now.normal, distance};
  if (shape == Shape::by_height) return {rim, times(1 / height, out), height};
  if (shape == Shape::by_height_times_side) {
    return {rim, times(1 / (side * height), out), side * height};
  }
  return {rim, distance == 0 ? times(side, now.normal) : times(1 / distance, out), distance};
}

struct View {
  Shape shape = Shape::disc;
  double velocity = 1, spin = 1;  // how much of the racket's movement the damper sees
  double damper = 1;
  bool push_only_obeyed = true;
  bool moves = true;
  bool since_obeyed = true;
  bool disc_in_test = false, disc_in_overlap = false;  // the disc's radius for the ball's
};

inline Triple force_with(const Moment& m, const View& view) {
  Moment at = m;
  if (!view.moves) at.t = m.setting.since;
  if (!view.since_obeyed) at.setting.since = 0;
  const Now now = racket_at(at);
  Setting s = m.setting;
  s.damping *= view.damper;
  s.push_only = s.push_only && view.push_only_obeyed;
  const NearestFound near = nearest_of(s, now, m.motion.position, view.shape);
  if (!(near.distance < (view.disc_in_test ? s.disc_radius : s.radius))) return up(-m.weight());
  const double overlap = (view.disc_in_overlap ? s.disc_radius : s.radius) - near.distance;
  const Triple surface = plus(times(view.velocity, s.disc_velocity),
                              cross(s.disc_spin, plus(near.point, now.centre, -1)), view.spin);
  const double away = dot(near.direction, plus(m.motion.velocity, surface, -1));
  return plus(up(-m.weight()), near.direction, push(s, overlap, away));
}
inline Triple right(const Moment& m) { return force_with(m, View{}); }

/// Over the disc, or how far beside it.
inline std::string disc_place(const Moment& m, const Now& now) {
  const Triple way = plus(m.motion.position, now.centre, -1);
  const double height = dot(now.normal, way);
  const double lateral = length(plus(way, now.normal, -height)), over = m.setting.disc_radius;
  if (lateral == 0) return "straight above the centre";
  if (lateral < over) {
    return m.setting.side * height < 0 ? "over the disc, with the centre pressed through it"
           : m.setting.side > 0        ? "over the disc"
                                       : "over the disc's back (side = -1)";
  }
  if (lateral == over) return "at the rim";
  return lateral < over + m.setting.radius ? "beside the disc, near its rim"
                                           : "far beside the disc";
}

enum Where { over, beside, anywhere };

/// Balls near the disc, on both sides; `movement`: how fast the racket moves and turns.
inline std::vector<Moment> moments(unsigned seed, Where where, double movement,
                                   bool push_only_too) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 40; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.push_only = push_only_too && i % 2 == 1;
    s.centre = dice.triple(1);
    s.disc_normal = dice.direction();
    s.disc_radius = dice.between(0.2, 0.5);
    s.disc_velocity = dice.triple(movement);
    s.disc_spin = dice.triple(movement);
    s.side = dice.sign() < 0 ? -1 : 1;
    s.since = movement > 0 ? dice.between(-1, 1) : 0;
    Moment m{s, movement > 0 ? s.since + dice.between(0, 0.4) : 0, {{}, dice.triple(5)}};
    const Now now = racket_at(m);
    // A direction along the disc, and how far out and up the ball is.
    Triple across = cross(now.normal, dice.direction());
    across = times(1 / length(across), across);
    const double out = where == over                   ? dice.between(0.01, 0.99) * s.disc_radius
                       : where == beside && i % 3 == 2 ? dice.between(1.1, 4) * s.disc_radius
                       : where == beside ? s.disc_radius + dice.between(0.01, 0.7) * s.radius
                                         : dice.between(0.1, 1.8) * s.disc_radius;
    const bool deep = where == over && i % 5 == 4;  // far through the disc
    const double high = s.side * dice.between(deep ? -9 : -0.3, 1.2) * s.radius;
    m.motion.position = plus(plus(now.centre, across, out), now.normal, high);
    all.push_back(m);
  }
  return all;
}

}  // namespace bounce::check::racket_game
