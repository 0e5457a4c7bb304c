#pragma once
#include <cmath>
#include <string>

#include "checks/law.hpp"

// A second, plain implementation of the racket, with the ways in which it can be got wrong.

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

enum class Shape { disc, rim_included, larger, infinite, square, no_rim, flat_rim, one_sided };

inline NearestFound nearest_of(const Setting& s, const Now& now, const Triple& ball, Shape shape) {
  const Triple way = plus(ball, now.centre, -1);
  const double height = dot(now.normal, way);
  const Triple outwards = plus(way, now.normal, -height);
  const double lateral = length(outwards);
  const double side = shape == Shape::one_sided ? 1 : s.side;
  bool over = lateral < s.disc_radius;
  if (shape == Shape::rim_included) over = lateral <= s.disc_radius;
  if (shape == Shape::larger) over = lateral < s.disc_radius + s.radius;
  if (shape == Shape::infinite) over = true;
  if (shape == Shape::square) {
    over = std::abs(outwards[0]) < s.disc_radius && std::abs(outwards[2]) < s.disc_radius;
  }
  if (over) return {plus(now.centre, outwards), times(side, now.normal), side * height};
  if (shape == Shape::no_rim) return {plus(now.centre, outwards), times(side, now.normal), 1e30};
  const Triple rim = plus(now.centre, outwards, s.disc_radius / lateral);
  if (shape == Shape::flat_rim) return {rim, times(side, now.normal), side * height};
  const Triple out = plus(ball, rim, -1);
  const double distance = length(out);
  return {rim, distance == 0 ? times(side, now.normal) : times(1 / distance, out), distance};
}

struct View {
  Shape shape = Shape::disc;
  double velocity = 1, spin = 1;  // how much of the racket's movement the damper sees
  double damper = 1;
  bool push_only_obeyed = true;
  bool moves = true;
  bool since_obeyed = true;
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
  if (!(near.distance < s.radius)) return up(-m.weight());
  const Triple surface = plus(times(view.velocity, s.disc_velocity),
                              cross(s.disc_spin, plus(near.point, now.centre, -1)), view.spin);
  const double away = dot(near.direction, plus(m.motion.velocity, surface, -1));
  return plus(up(-m.weight()), near.direction, push(s, s.radius - near.distance, away));
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

}  // namespace bounce::check::racket_game
