#pragma once
#include <cmath>

#include "checks/08_racket_game_law.hpp"
#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

// The questions about a racket, and what learners get wrong there.

namespace bounce::check::racket_game {

inline std::string racket_text(const Moment& m) {
  const Setting& s = m.setting;
  return "ball at " + numbers(m.motion.position) + " m; disc at " + numbers(s.centre) +
         " m, normal " + numbers(s.disc_normal) + ", radius " + number(s.disc_radius) +
         " m; side " + number(s.side);
}

inline Question<Moment> question(const std::string& tested, const std::string& unit) {
  Question<Moment> q;
  q.tested = tested;
  q.unit = unit;
  q.names = {"x", "y", "z"};
  q.lesson = "docs/08_racket_game.md, \"The idea\"";
  q.rounding = [](const Moment&) { return 1e-12; };  // metres and unit vectors, near the rim too
  q.where = racket_text;
  q.when = one_moment;
  q.look_at =
      "split the way from the centre to the ball: `height` along the normal, `outwards` along the "
      "disc. Shorter than racket.radius: over the disc. Else the nearest point is on the rim.";
  return q;
}

template <class Part>
inline Question<Moment> nearest_question(const std::string& tested, const std::string& unit,
                                         Part part) {
  Question<Moment> q = question(tested, unit);
  q.answer = [part](const Moment& m) {
    return part(subject().nearest(m.setting, m.motion.position));
  };
  const auto as = [part](Shape shape) {
    return [part, shape](const Moment& m) {
      const Now now{m.setting.centre, m.setting.disc_normal};
      return part(nearest_of(m.setting, now, m.motion.position, shape));
    };
  };
  q.truth = as(Shape::disc);
  q.suspects = {
      {"<= instead of <",
       "exactly on the rim is beside the disc: *shorter* out than its radius is over it.",
       as(Shape::rim_included)},
      {"rim ignored",
       "beside the disc the push goes from the rim to the ball: that is the direction, and its "
       "length is the distance.",
       as(Shape::flat_rim)},
      {"infinite racket", "the racket ends: beside the disc the nearest point is on its rim.",
       as(Shape::infinite)},
      {"rim ignored", "beside the disc the ball may still touch the rim.", as(Shape::no_rim)},
      {"the ball's radius added to the racket's",
       "over the disc or not is a question of the ball's *centre*: shorter out than racket.radius.",
       as(Shape::larger)},
      {"square racket",
       "x and z are tested one by one, so the racket has corners. What counts is the length of "
       "`outwards`.",
       as(Shape::square)},
      {"side ignored", "a ball from below is pushed down: normal and height times `side`.",
       as(Shape::one_sided)}};
  const auto suspect = [&](const char* mistake, const char* advice,
                           std::initializer_list<Shape> shapes) {
    for (const Shape shape : shapes) q.suspects.push_back({mistake, advice, as(shape)});
  };
  suspect("the ball's radius for the disc's", "`radius` is the ball's, `racket.radius` the disc's.",
          {Shape::small_test, Shape::small_rim, Shape::small});
  suspect("direction reversed", "beside the disc it goes from the rim to the ball: ball - rim.",
          {Shape::reversed});
  suspect("side beside the disc",
          "`side` counts over the disc. Beside it the direction is from the rim to the ball, and "
          "the distance is positive.",
          {Shape::side_at_rim});
  suspect("the normal for the direction",
          "beside the disc the push goes from the rim to the ball, not along the normal.",
          {Shape::normal_at_rim});
  suspect("the height for the distance",
          "beside the disc the distance is the length of ball - rim. Divide by that.",
          {Shape::by_height, Shape::by_height_times_side});
  suspect("the centre forgotten",
          "`outwards` begins at the racket's centre: add racket.centre for a point.",
          {Shape::no_centre});
  q.place = [](const Moment& m) {
    return disc_place(m, {m.setting.centre, m.setting.disc_normal});
  };
  q.zero = [](const Moment& m) -> std::string {
    const Now now{m.setting.centre, m.setting.disc_normal};
    const NearestFound right = nearest_of(m.setting, now, m.motion.position, Shape::disc);
    if (right.distance == 0) return "the distance is 0 there";
    const double out = length(plus(right.point, now.centre, -1));
    return out == 0 ? "the length of `outwards` is 0 there" : "";
  };
  const auto other = [&](const char* name, auto value) {
    q.parts.push_back(
        {name, name == std::string("the right one") ? 1.0 : 0.0, [=](const Moment& m) {
           const Now now{m.setting.centre, m.setting.disc_normal};
           const Triple way = plus(m.motion.position, now.centre, -1);
           const double h = dot(now.normal, way);
           const Triple out = plus(way, now.normal, -h);
           const NearestFound right = nearest_of(m.setting, now, m.motion.position, Shape::disc);
           return value(m, now, h, out, right);
         }});
  };
  using T = const Triple&;
  using M = const Moment&;
  using R = const NearestFound&;
  if (unit.empty()) {  // the direction
    other("the right one", [](M, const Now&, double, T, R r) { return r.direction; });
    other("the normal, without `side`,", [](M, const Now& n, double, T, R) { return n.normal; });
    other("the way itself, not divided by its length,",
          [](M, const Now&, double, T, R r) { return times(r.distance, r.direction); });
    other("`outwards`", [](M, const Now&, double, T out, R) { return out; });
    return q;
  }
  if (tested == "the distance") {
    other("the right one", [](M, const Now&, double, T, R r) { return up(r.distance); });
    other("the height, without `side`,", [](M, const Now&, double h, T, R) { return up(h); });
    other("the height's size", [](M, const Now&, double h, T, R) { return up(std::abs(h)); });
    other("the length of `outwards`",
          [](M, const Now&, double, T out, R) { return up(length(out)); });
    return q;
  }
  q.parts.push_back({"the centre", 1, [](M m) { return m.setting.centre; }});
  other("`outwards` cut at the rim",
        [](M m, const Now&, double, T, R r) { return plus(r.point, m.setting.centre, -1); });
  q.parts.back().wanted = 1;
  other("`outwards` in full", [](M, const Now&, double, T out, R) { return out; });
  other("`outwards` times the radius",
        [](M m, const Now&, double, T out, R) { return times(m.setting.disc_radius, out); });
  other("the height along the normal",
        [](M, const Now& n, double h, T, R) { return times(h, n.normal); });
  return q;
}

inline Triple point_of(const NearestFound& n) { return n.point; }
inline Triple direction_of(const NearestFound& n) { return n.direction; }
inline Triple distance_of(const NearestFound& n) { return up(n.distance); }

inline Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q = question(tested, "N");
  q.names = {"Fx", "Fy", "Fz"};
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = right;
  // Near the rim the direction is a difference of positions divided by a small distance.
  q.rounding = [](const Moment& m) { return 100 * force_rounding(m); };
  q.where = [](const Moment& m) {
    return in_space(m) + "; " + racket_text(m) + ", moving with " +
           numbers(m.setting.disc_velocity) + " m/s, turning with " + numbers(m.setting.disc_spin) +
           " rad/s";
  };
  q.look_at = "the law of stage 7, with nearest(disc_at(t), position) for distance and direction.";
  const auto contact = [](const Moment& m) {
    const NearestFound near = nearest_of(m.setting, racket_at(m), m.motion.position, Shape::disc);
    const Triple surface =
        plus(m.setting.disc_velocity,
             cross(m.setting.disc_spin, plus(near.point, racket_at(m).centre, -1)));
    return Contact{near.direction, m.setting.radius - near.distance,
                   dot(near.direction, plus(m.motion.velocity, surface, -1)),
                   near.distance < m.setting.radius};
  };
  q.place = [=](const Moment& m) -> std::string {
    return contact(m).touches ? "in contact " + disc_place(m, racket_at(m)) : "in the air";
  };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself);
  q.factors = force_factors<Moment>(contact, itself);
  q.parts.push_back({"c times the racket's velocity", 0, [=](const Moment& m) {
                       const Contact c = contact(m);
                       const double own = dot(c.direction, m.motion.velocity);
                       return times(c.touches ? m.setting.damping * (own - c.away) : 0,
                                    c.direction);
                     }});
  q.parts.back().inside = true;
  const auto with = [](View view) {
    return [view](const Moment& m) { return force_with(m, view); };
  };
  q.suspects = {
      {"gravity points up", "y is up and gravity pulls downwards.",
       [](const Moment& m) { return plus(right(m), up(2 * m.weight())); }},
      {"mass forgotten", "a force is wanted, and gravity alone is an acceleration.",
       [](const Moment& m) { return plus(right(m), up(m.weight() - m.setting.gravity)); }},
      {"racket velocity ignored",
       "the damper brakes one surface against the other: it sees the ball's velocity minus "
       "racket.velocity_of(point).",
       with({.velocity = 0, .spin = 0})},
      {"spin ignored",
       "a racket that turns moves differently at its rim than at its centre: "
       "racket.velocity_of(point).",
       with({.spin = 0})},
      {"racket velocity with the wrong sign", "ball *minus* racket.",
       with({.velocity = -1, .spin = -1})},
      {"since forgotten",
       "the racket is where `disc` says at the time `since`, not at time 0: disc_at(t).",
       with({.since_obeyed = false})},
      {"racket at rest", "the racket moves: disc_at(t) is where it is at time t.",
       with({.moves = false})},
      {"the damper has the wrong sign", "a brake points against the velocity.",
       with({.damper = -1})},
      {"push_only forgotten", "with contact push_only the push is std::max(0.0, spring + damper).",
       with({.push_only_obeyed = false})},
      {"infinite racket", "the racket ends at its rim.", with({.shape = Shape::infinite})},
      {"rim ignored", "the rim pushes, too.", with({.shape = Shape::no_rim})},
      {"the push along y", "the push goes along the direction of nearest().", [](const Moment& m) {
         const Triple f = plus(right(m), up(m.weight()));
         return up(length(f) - m.weight());
       }}};
  for (const bool in_test : {false, true}) {
    q.suspects.push_back({"the disc's radius for the ball's",
                          "`radius` is the ball's: the overlap is radius - distance.",
                          with({.disc_in_test = in_test, .disc_in_overlap = true})});
  }
  return q;
}

}  // namespace bounce::check::racket_game
