#include <doctest/doctest.h>

#include "checks/run_check.hpp"

using namespace bounce::check;

namespace {

/// Two balls, and the contact between them.
struct Two {
  Setting setting;
  OneOfMany one, two;
  Triple between() const { return plus(one.motion.position, two.motion.position, -1); }
  double d() const { return length(between()); }
  double overlap() const { return one.radius + two.radius - d(); }
  Triple e12() const { return times(1 / d(), between()); }  // from ball 2 to ball 1
  Triple slip() const { return plus(one.motion.velocity, two.motion.velocity, -1); }
  double separation() const { return dot(slip(), e12()); }
};

std::string two_text(const Two& p) {
  return "ball 1 at " + numbers(p.one.motion.position) + " m with " +
         numbers(p.one.motion.velocity) + " m/s, radius " + number(p.one.radius) + "; ball 2 at " +
         numbers(p.two.motion.position) + " m with " + numbers(p.two.motion.velocity) +
         " m/s, radius " + number(p.two.radius) + "; stiffness " + number(p.setting.stiffness) +
         ", damping " + number(p.setting.damping);
}

Question<Two> question(const std::string& tested, const std::string& unit) {
  Question<Two> q;
  q.tested = tested;
  q.unit = unit;
  q.names = {"x", "y", "z"};
  q.lesson = "docs/05_ball_collision.md, \"The idea\"";
  q.rounding = [](const Two&) { return 1e-13; };  // metres, m/s and unit vectors
  q.where = two_text;
  q.when = [](const Two&) { return std::string("one moment; a single evaluation, so no dt"); };
  return q;
}

/// Pairs whose overlap is between `least` and `most` metres.
std::vector<Two> pairs(unsigned seed, double least, double most, bool push_only_too = false) {
  Dice dice(seed);
  std::vector<Two> all;
  for (int i = 0; i < 30; ++i) {
    Two p{any_setting(dice), {}, {}};
    p.setting.damping = dice.between(1, 300);
    p.setting.push_only = push_only_too && i % 2 == 1;
    p.one = {{dice.triple(2), dice.triple(5)}, dice.between(0.1, 0.3), dice.between(0.5, 3)};
    p.two = {{{}, dice.triple(5)}, dice.between(0.1, 0.3), dice.between(0.5, 3)};
    const double d = p.one.radius + p.two.radius - dice.between(least, most);
    p.two.motion.position = plus(p.one.motion.position, dice.direction(), d);
    all.push_back(p);
  }
  return all;
}

Triple force_along(const Two& p, double overlap, double separation, const Triple& e) {
  return overlap > 0 ? times(push(p.setting, overlap, separation), e) : Triple{};
}
Triple right(const Two& p) { return force_along(p, p.overlap(), p.separation(), p.e12()); }

Question<Two> force_question() {
  Question<Two> q = question("the force on ball 1", "N");
  q.names = {"Fx", "Fy", "Fz"};
  q.answer = [](const Two& p) { return subject().pair_force(p.setting, p.one, p.two); };
  q.truth = right;
  q.rounding = [](const Two& p) { return 1e-12 * (p.setting.stiffness + 10 * p.setting.damping); };
  q.look_at = "spring and damper of stage 3, from overlap and separation speed, along e12.";
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

/// A few balls at once, the first of which is looked at.
struct Crowd {
  Setting setting;
  std::vector<OneOfMany> balls;
};

struct CrowdView {
  double on_second = -1;  // of each pair, how much of the force the second ball gets
  double twice = 1;
  bool weight = true;
  bool by_mass = true;
};

/// The acceleration of ball `i`, by a plain double loop.
Triple acceleration_in(const Crowd& crowd, std::size_t i, const CrowdView& view) {
  const Setting& s = crowd.setting;
  const OneOfMany& me = crowd.balls[i];
  Triple force = up(view.weight ? -me.mass * s.gravity : 0);
  const double depth = me.radius - me.motion.position[1];
  if (s.floor && depth > 0) force = plus(force, up(push(s, depth, me.motion.velocity[1])));
  for (std::size_t j = 0; j < crowd.balls.size(); ++j) {
    if (j == i) continue;
    const std::size_t first = std::min(i, j), second = std::max(i, j);
    const Two p{s, crowd.balls[first], crowd.balls[second]};
    force = plus(force, right(p), view.twice * (i == first ? 1 : view.on_second));
  }
  return view.by_mass ? times(1 / me.mass, force) : force;
}

Crowd crowd_of(Dice& dice, int count, double room) {
  Crowd crowd{any_setting(dice), {}};
  crowd.setting.damping = dice.between(1, 100);
  for (int i = 0; i < count; ++i) {
    OneOfMany ball{
        {dice.triple(room), dice.triple(3)}, dice.between(0.1, 0.3), dice.between(0.5, 3)};
    ball.motion.position[1] += room + 0.1;
    crowd.balls.push_back(ball);
  }
  return crowd;
}

struct OneInCrowd {
  Crowd crowd;
  std::size_t i;
};

Question<OneInCrowd> crowd_question() {
  Question<OneInCrowd> q;
  q.tested = "the acceleration of one ball among several";
  q.unit = "m/s^2";
  q.names = {"ax", "ay", "az"};
  q.lesson = "docs/05_ball_collision.md, \"The program\"";
  q.answer = [](const OneInCrowd& c) {
    return subject().accelerations(c.crowd.setting, c.crowd.balls).at(c.i);
  };
  const auto with = [](CrowdView view) {
    return [view](const OneInCrowd& c) { return acceleration_in(c.crowd, c.i, view); };
  };
  q.truth = with({});
  q.rounding = [](const OneInCrowd& c) {  // some tens of pairs, each with 1e5 N/m times 0.5 m
    return 1e-11 * c.crowd.setting.stiffness;
  };
  q.where = [](const OneInCrowd& c) {
    return "ball " + std::to_string(c.i) + " of " + std::to_string(c.crowd.balls.size()) + " at " +
           numbers(c.crowd.balls[c.i].motion.position) + " m, mass " +
           number(c.crowd.balls[c.i].mass) + ", stiffness " + number(c.crowd.setting.stiffness);
  };
  q.when = [](const OneInCrowd&) {
    return std::string("one moment; a single evaluation, so no dt");
  };
  q.look_at = "gravity, floor, and for each pair once: + force on ball i, - force on ball j.";
  q.suspects = {
      {"force on one ball only", "action and reaction: ball j gets the opposite force.",
       with({.on_second = 0})},
      {"both balls pushed the same way", "equal and *opposite*: force_.col(j) -= force.",
       with({.on_second = 1})},
      {"both balls pushed the wrong way", "pair_force is the force on the first of the two.",
       with({.twice = -1})},
      {"pairs counted twice",
       "each pair's force is there twice. A pair is one pair: i < j, not all i and all j.",
       with({.twice = 2})},
      {"stiffness halved by counting pairs twice",
       "each ball gets half of the force. Each pair comes once, so nothing is to be halved.",
       with({.twice = 0.5})},
      {"no forces between the balls", "the pairs are missing: this is gravity and the floor.",
       with({.twice = 0})},
      {"mass forgotten", "this is the force. Divide it by the mass of each ball.",
       with({.by_mass = false})},
      {"gravity forgotten", "each ball has its weight.", with({.weight = false})}};
  return q;
}

std::vector<OneInCrowd> all_of(const std::vector<Crowd>& crowds) {
  std::vector<OneInCrowd> all;
  for (const Crowd& crowd : crowds) {
    for (std::size_t i = 0; i < crowd.balls.size(); ++i) all.push_back({crowd, i});
  }
  return all;
}

}  // namespace

TEST_SUITE("05_ball_collision") {
  TEST_CASE("the overlap is r1 + r2 - d") {
    Question<Two> q = question("the overlap of two balls", "m");
    q.names = {"", "overlap", ""};
    q.answer = [](const Two& p) { return up(subject().meet(p.one, p.two).overlap); };
    q.truth = [](const Two& p) { return up(p.overlap()); };
    q.look_at = "r1 + r2 - d, where d is the distance of the centres.";
    q.suspects = {{"2 r instead of r1 + r2", "the two radii may differ: r1 + r2.",
                   [](const Two& p) { return up(2 * p.one.radius - p.d()); }},
                  {"2 r instead of r1 + r2", "the two radii may differ: r1 + r2.",
                   [](const Two& p) { return up(2 * p.two.radius - p.d()); }},
                  {"one radius only", "both balls have a radius: r1 + r2 - d.",
                   [](const Two& p) { return up(p.one.radius - p.d()); }},
                  {"the overlap's sign", "it is positive while they overlap: r1 + r2 - d.",
                   [](const Two& p) { return up(-p.overlap()); }}};
    judge(q, pairs(51, 0.001, 0.08));
  }
  TEST_CASE("e12 has length 1 and points from ball 2 to ball 1") {
    Question<Two> q = question("the unit vector e12", "");
    q.answer = [](const Two& p) { return subject().meet(p.one, p.two).e12; };
    q.truth = [](const Two& p) { return p.e12(); };
    q.look_at = "(p1 - p2) / d.";
    q.suspects = {{"e12 the wrong way round", "it points from ball 2 to ball 1: p1 - p2.",
                   [](const Two& p) { return times(-1, p.e12()); }},
                  {"unit vector not normalised", "its length is not 1: divide by d.",
                   [](const Two& p) { return p.between(); }}};
    judge(q, pairs(52, 0.001, 0.08));
  }
  TEST_CASE("the separation speed is the relative velocity along e12") {
    Question<Two> q = question("the separation speed", "m/s");
    q.names = {"", "speed", ""};
    q.rounding = [](const Two&) { return 1e-12; };
    q.answer = [](const Two& p) { return up(subject().meet(p.one, p.two).separation_speed); };
    q.truth = [](const Two& p) { return up(p.separation()); };
    q.look_at = "(v1 - v2) . e12, positive while the two move apart.";
    q.suspects = {
        {"the separation speed's sign", "positive while they move apart: (v1 - v2) . e12.",
         [](const Two& p) { return up(-p.separation()); }},
        {"the size of the velocity", "only the part along e12 counts: a dot product.",
         [](const Two& p) { return up(length(p.slip())); }},
        {"one velocity only", "it takes both velocities: v1 - v2.",
         [](const Two& p) { return up(dot(p.one.motion.velocity, p.e12())); }}};
    judge(q, pairs(53, 0.001, 0.08));
  }
  TEST_CASE("two balls that do not touch, or only just, feel nothing") {
    judge(force_question(), pairs(54, -1, -0.001));
    std::vector<Two> edge = pairs(55, 0, 0);
    for (Two& p : edge) {  // numbers that add up without rounding
      p.one.radius = p.two.radius = 0.25;
      p.one.motion.position = {0.5, 0, 0};
      p.two.motion.position = {0, 0, 0};
    }
    judge(force_question(), edge);
    Question<Two> q = question("e12 of two balls that only just touch", "");
    q.answer = [](const Two& p) { return subject().meet(p.one, p.two).e12; };
    q.truth = [](const Two&) { return Triple{}; };
    q.look_at = "where the overlap is not positive, return the meeting at once: the rest is empty.";
    judge(q, edge);
  }
  TEST_CASE("the force on ball 1: spring and damper along e12") {
    judge(force_question(), pairs(56, 0.001, 0.08));
    judge(force_question(), pairs(57, 0.001, 0.02, true));
  }
  TEST_CASE("centres that coincide: ball 1 goes up, and nothing becomes not-a-number") {
    std::vector<Two> same = pairs(58, 0.1, 0.1);
    for (Two& p : same) p.two.motion.position = p.one.motion.position;
    Question<Two> q = force_question();
    q.truth = [](const Two& p) {
      const double both = p.one.radius + p.two.radius;
      return up(push(p.setting, both, p.slip()[1]));
    };
    q.look_at = "d is 0 there, and 0 / 0 is no direction. Take (0, 1, 0).";
    q.suspects = {};
    judge(q, same);
    std::vector<Two> close = same;  // a small distance is a direction, too
    for (Two& p : close) p.one.motion.position = up(1e-20), p.two.motion.position = {};
    for (std::size_t i = 0; i < close.size(); ++i) {
      if (i % 2 == 0) close[i].one.motion.position = {1e-20, 0, 0};
    }
    Question<Two> small = force_question();
    small.look_at = "only centres that coincide have no direction. A small distance has one.";
    judge(small, close);
  }
  TEST_CASE("all balls: each pair once, equal and opposite") {
    Dice dice(59);
    std::vector<Crowd> crowds;
    for (const int count : {2, 3, 5, 8}) crowds.push_back(crowd_of(dice, count, 0.3));
    judge(crowd_question(), all_of(crowds));
  }
  TEST_CASE("without a floor, and with so many balls that the grid finds the pairs") {
    Dice dice(60);
    Crowd free = crowd_of(dice, 4, 0.3);
    free.setting.floor = false;
    for (OneOfMany& ball : free.balls) ball.motion.position[1] -= 0.5;
    judge(crowd_question(), all_of({free, crowd_of(dice, 47, 0.8), crowd_of(dice, 48, 0.8),
                                    crowd_of(dice, 60, 0.8)}));
  }
  TEST_CASE("two balls collide and part again as the formula says, for several dt") {
    Dice dice(61);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * std::sqrt(2 * s.stiffness * s.mass);
      runs.push_back(pair_run(s, dice.direction(), dice.between(1, 4), dt));
    }
    judge_runs("docs/05_ball_collision.md, \"The program\"", runs);
  }
}
