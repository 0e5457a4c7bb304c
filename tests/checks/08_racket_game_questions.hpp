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
      "disc. Shorter than the radius: over the disc. Else the nearest point is on the rim.";
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
  q.place = [](const Moment& m) {
    return disc_place(m, {m.setting.centre, m.setting.disc_normal});
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
  return q;
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
