#include <doctest/doctest.h>

#include <cmath>

#include "checks/run_check.hpp"

using namespace bounce::check;

namespace {

/// The racket at the moment's time: moved and turned (Rodrigues' formula).
struct Now {
  Triple centre, normal;
};
Now racket_at(const Moment& m) {
  const Setting& s = m.setting;
  const double speed = length(s.disc_spin);
  Now now{plus(s.centre, s.disc_velocity, m.t), s.disc_normal};
  if (speed == 0) return now;
  const Triple axis = times(1 / speed, s.disc_spin), &n = s.disc_normal;
  const double c = std::cos(speed * m.t), d = std::sin(speed * m.t);
  now.normal = plus(plus(times(c, n), cross(axis, n), d), axis, dot(axis, n) * (1 - c));
  return now;
}

enum class Shape { disc, infinite, square, no_rim, flat_rim, one_sided };

NearestFound nearest_of(const Setting& s, const Now& now, const Triple& ball, Shape shape) {
  const Triple way = plus(ball, now.centre, -1);
  const double height = dot(now.normal, way);
  const Triple outwards = plus(way, now.normal, -height);
  const double lateral = length(outwards);
  const double side = shape == Shape::one_sided ? 1 : s.side;
  bool over = lateral < s.disc_radius;
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
};

Triple force_with(const Moment& m, const View& view) {
  Moment at = m;
  if (!view.moves) at.t = 0;
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
Triple right(const Moment& m) { return force_with(m, View{}); }

std::string racket_text(const Moment& m) {
  const Setting& s = m.setting;
  return "ball at " + numbers(m.motion.position) + " m; disc at " + numbers(s.centre) +
         " m, normal " + numbers(s.disc_normal) + ", radius " + number(s.disc_radius) +
         " m; side " + number(s.side);
}

Question<Moment> question(const std::string& tested, const std::string& unit) {
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
Question<Moment> nearest_question(const std::string& tested, const std::string& unit, Part part) {
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
      {"rim ignored",
       "beside the disc the push goes from the rim to the ball: that is the direction, and its "
       "length is the distance.",
       as(Shape::flat_rim)},
      {"infinite racket", "the racket ends: beside the disc the nearest point is on its rim.",
       as(Shape::infinite)},
      {"rim ignored", "beside the disc the ball may still touch the rim.", as(Shape::no_rim)},
      {"square racket",
       "x and z are tested one by one, so the racket has corners. What counts is the length of "
       "`outwards`.",
       as(Shape::square)},
      {"side ignored", "a ball from below is pushed down: normal and height times `side`.",
       as(Shape::one_sided)}};
  return q;
}

Triple point_of(const NearestFound& n) { return n.point; }
Triple direction_of(const NearestFound& n) { return n.direction; }
Triple distance_of(const NearestFound& n) { return up(n.distance); }

Question<Moment> force_question(const std::string& tested) {
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
      {"racket at rest", "the racket moves: disc_at(t) is where it is at time t.",
       with({.moves = false})},
      {"the damper has the wrong sign", "a brake points against the velocity.",
       with({.damper = -1})},
      {"push_only forgotten", "with contact push_only the push is max(0, spring + damper).",
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
std::vector<Moment> moments(unsigned seed, Where where, double movement, bool push_only_too) {
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
    Moment m{s, movement > 0 ? dice.between(0, 0.4) : 0, {{}, dice.triple(5)}};
    const Now now = racket_at(m);
    // A direction along the disc, and how far out and up the ball is.
    Triple across = cross(now.normal, dice.direction());
    across = times(1 / length(across), across);
    const double out = where == over     ? dice.between(0.01, 0.99) * s.disc_radius
                       : where == beside ? s.disc_radius + dice.between(0.01, 0.7) * s.radius
                                         : dice.between(0.1, 1.8) * s.disc_radius;
    const double high = s.side * dice.between(-0.3, 1.2) * s.radius;
    m.motion.position = plus(plus(now.centre, across, out), now.normal, high);
    all.push_back(m);
  }
  return all;
}

}  // namespace

TEST_SUITE("08_racket_game") {
  TEST_CASE("over the disc the nearest point is straight below the ball") {
    judge(nearest_question("the nearest point of the racket", "m", point_of),
          moments(81, over, 0, false));
  }
  TEST_CASE("over the disc the push goes along the normal, to the ball's side") {
    judge(nearest_question("the direction of the push", "", direction_of),
          moments(82, over, 0, false));
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, moments(82, over, 0, false));
  }
  TEST_CASE("is the ball on the disc? Beside it the nearest point is on the rim") {
    judge(nearest_question("the nearest point of the racket", "m", point_of),
          moments(83, beside, 0, false));
  }
  TEST_CASE("beside the disc the push goes from the rim to the ball") {
    judge(nearest_question("the direction of the push", "", direction_of),
          moments(84, beside, 0, false));
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, moments(84, beside, 0, false));
  }
  TEST_CASE("a ball exactly on the rim, or exactly a radius out") {
    std::vector<Moment> edge = moments(85, over, 0, false);
    for (std::size_t i = 0; i < edge.size(); ++i) {  // numbers that add up without rounding
      Moment& m = edge[i];
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.disc_radius = 0.5;
      m.motion.position = {0.5, i % 2 == 0 ? 0 : -0.25, 0};
    }
    judge(nearest_question("the direction of the push", "", direction_of), edge);
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, edge);
  }
  TEST_CASE("a racket at rest: gravity, and the law of stage 7 along the push") {
    judge(force_question("the force on the ball"), moments(86, anywhere, 0, false));
  }
  TEST_CASE("a racket that moves and turns: the damper sees the velocity between the two") {
    judge(force_question("the force on the ball"), moments(87, anywhere, 3, false));
  }
  TEST_CASE("both kinds of contact") {
    judge(force_question("the force on the ball"), moments(88, over, 3, true));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(89, over, 0, false);
    for (Moment& m : edge) {
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.radius = 0.25;
      m.setting.side = 1;
      m.motion.position = {0, 0.25, 0};
    }
    judge(force_question("the force on a ball at exactly distance r"), edge);
  }
  TEST_CASE("the side changes only while the two do not touch") {
    Question<Moment> q = question("the side that choose_side keeps or chooses", "");
    q.names = {"", "side", ""};
    q.answer = [](const Moment& m) {
      return up(subject().side_after(m.setting, m.t, m.motion.position));
    };
    q.truth = [](const Moment& m) {
      const Setting& s = m.setting;
      const Now now = racket_at(m);
      const Triple way = plus(m.motion.position, now.centre, -1);
      const double height = dot(now.normal, way);
      const bool is_over = length(plus(way, now.normal, -height)) < s.disc_radius;
      const bool touches = is_over && s.side * height < s.radius;
      return up(touches ? s.side : height < 0 ? -1 : 1);
    };
    q.rounding = [](const Moment&) { return 0; };
    q.look_at = "over the disc, and side * height < radius: keep it. Else the side of the height.";
    judge(q, moments(90, anywhere, 3, false));
    std::vector<Moment> far = moments(91, anywhere, 3, false);
    for (Moment& m : far) {
      m.motion.position = plus(m.motion.position, m.setting.disc_normal, -4 * m.setting.side);
    }
    judge(q, far);
    std::vector<Moment> edge = moments(92, over, 0, false);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      Moment& m = edge[i];
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.disc_radius = 0.5;
      m.setting.radius = 0.25;
      static const Triple places[] = {
          {0.5, 0.125, 0}, {0.5, 0, 0}, {0, 0.25, 0}, {0, -0.25, 0}, {0, 0, 0}};
      m.motion.position = places[i % 5];
    }
    judge(q, edge);
  }
  TEST_CASE("the ball bounces once on a disc at rest, as the formula says, for several dt") {
    Dice dice(93);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
      Triple n = dice.direction();
      n[1] = 1 + std::abs(n[1]);
      n = times(1 / length(n), n);
      s.disc_normal = n;
      s.disc_radius = 30;
      runs.push_back(bounce_run(s, n, dice.between(0.3, 1.5), dt));
    }
    judge_runs("docs/08_racket_game.md, \"The program\"", runs);
  }
}
