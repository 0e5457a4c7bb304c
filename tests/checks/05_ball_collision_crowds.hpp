#pragma once
#include "checks/05_ball_collision_questions.hpp"

// The questions about several balls at once.

namespace bounce::check::ball_collision {

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
  bool contact_of_the_floor = false, not_where_they_coincide = false, neighbours_only = false,
       first_left_out = false;
  bool first_overwritten = false, second_overwritten = false;
};

/// The acceleration of ball `i`, by a plain double loop.
inline Triple acceleration_in(const Crowd& crowd, std::size_t i, const CrowdView& view) {
  const Setting& s = crowd.setting;
  const OneOfMany& me = crowd.balls[i];
  Triple force = up(view.weight ? -me.mass * s.gravity : 0);
  const double depth = me.radius - me.motion.position[1];
  if (s.floor && depth > 0) {
    Setting floor = s;
    floor.stiffness = s.floor_stiffness;
    floor.damping = s.floor_damping;
    force = plus(force, up(push(floor, depth, me.motion.velocity[1])));
  }
  for (std::size_t j = 0; j < crowd.balls.size(); ++j) {
    if (j == i) continue;
    const std::size_t first = std::min(i, j), second = std::max(i, j);
    Two p{s, crowd.balls[first], crowd.balls[second]};
    if (view.contact_of_the_floor) {
      p.setting.stiffness = s.floor_stiffness;
      p.setting.damping = s.floor_damping;
    }
    if (view.not_where_they_coincide && p.d() == 0) continue;
    if (view.first_left_out && first == 0) continue;
    if (view.neighbours_only && second != first + 1) continue;
    if (i == first ? view.first_overwritten : view.second_overwritten) force = {};
    force = plus(force, right(p), view.twice * (i == first ? 1 : view.on_second));
  }
  return view.by_mass ? times(1 / me.mass, force) : force;
}

inline Crowd crowd_of(Dice& dice, int count, double room) {
  Crowd crowd{any_setting(dice), {}};
  crowd.setting.damping = dice.between(1, 100);
  crowd.setting.floor_stiffness = std::pow(10, dice.between(3, 5));
  crowd.setting.floor_damping = dice.between(1, 100);
  crowd.setting.push_only = count % 2 == 1;
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

inline Question<OneInCrowd> crowd_question() {
  Question<OneInCrowd> q;
  q.tested = "the acceleration of one ball among several";
  q.unit = "m/s^2";
  q.names = {"ax", "ay", "az"};
  q.lesson = "docs/05_ball_collision.md, \"The idea\"";
  q.answer = [](const OneInCrowd& c) {
    return subject().accelerations(c.crowd.setting, c.crowd.balls).at(c.i);
  };
  const auto with = [](CrowdView view) {
    return [view](const OneInCrowd& c) { return acceleration_in(c.crowd, c.i, view); };
  };
  q.truth = with({});
  q.rounding = [](const OneInCrowd& c) {  // some tens of pairs, each with 1e5 N/m times 0.5 m
    return 1e-11 * (c.crowd.setting.stiffness + c.crowd.setting.floor_stiffness);
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
      {"the floor's contact between the balls",
       "two balls have a contact of their own: pair_contact(), not floor_contact().",
       with({.contact_of_the_floor = true})},
      {"no force where two centres coincide",
       "two balls in the same place push each other, too: meet() says in which direction.",
       with({.not_where_they_coincide = true})},
      {"the first ball is left out", "ball 0 meets others, too: indices begin at 0.",
       with({.first_left_out = true})},
      {"only neighbours in the list meet", "all pairs count, not only ball i and ball i + 1.",
       with({.neighbours_only = true})},
      {"gravity forgotten", "each ball has its weight.", with({.weight = false})}};
  for (const auto& [first, second] : {std::pair(true, true), {true, false}, {false, true}}) {
    q.suspects.push_back({"= in place of += or -=",
                          "`=` overwrites gravity, floor and the other pairs: use += and -=.",
                          with({.first_overwritten = first, .second_overwritten = second})});
  }
  q.place = [](const OneInCrowd& c) -> std::string {
    return c.i == 0                          ? "for the first ball"
           : c.i + 1 == c.crowd.balls.size() ? "for the last ball"
                                             : "for those between";
  };
  const auto part = [&](const char* name, double wanted, CrowdView view) {
    CrowdView without = view;
    without.twice = 0;
    q.parts.push_back({name, wanted, [=](const OneInCrowd& c) {
                         return plus(acceleration_in(c.crowd, c.i, view),
                                     acceleration_in(c.crowd, c.i, without), -1);
                       }});
  };
  q.parts.push_back({"gravity and floor", 1, with({.twice = 0})});
  part("the force on ball i of each pair", 1, {.on_second = 0});
  q.parts.push_back({"the force on ball j of each pair", 1, [](const OneInCrowd& c) {
                       return plus(acceleration_in(c.crowd, c.i, {}),
                                   acceleration_in(c.crowd, c.i, {.on_second = 0}), -1);
                     }});
  part("the force, not divided by the mass", 0, {.by_mass = false});
  q.factors = {{"the ball's mass", [](const OneInCrowd& c) { return c.crowd.balls[c.i].mass; }}};
  return q;
}

inline std::vector<OneInCrowd> all_of(const std::vector<Crowd>& crowds) {
  std::vector<OneInCrowd> all;
  for (const Crowd& crowd : crowds) {
    for (std::size_t i = 0; i < crowd.balls.size(); ++i) all.push_back({crowd, i});
  }
  return all;
}

}  // namespace bounce::check::ball_collision
