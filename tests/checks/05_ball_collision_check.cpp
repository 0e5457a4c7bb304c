#include "checks/05_ball_collision_crowds.hpp"

#include <doctest/doctest.h>

namespace bounce::check::ball_collision {

TEST_SUITE("05_ball_collision") {
  TEST_CASE("the overlap is r1 + r2 - d") {
    Question<Two> q = question("the overlap of two balls", "m");
    q.names = {"", "overlap", ""};
    q.answer = [](const Two& p) { return up(subject().meet(p.one, p.two).overlap); };
    q.truth = [](const Two& p) { return up(p.overlap()); };
    q.look_at = "r1 + r2 - d, where d is the distance of the centres.";
    q.parts = {{"r1", 1, [](const Two& p) { return up(p.one.radius); }},
               {"r2", 1, [](const Two& p) { return up(p.two.radius); }},
               {"- d", 1, [](const Two& p) { return up(-p.d()); }},
               {"d squared", 0, [](const Two& p) { return up(p.d() * p.d()); }},
               {"the larger radius", 0,
                [](const Two& p) { return up(std::max(p.one.radius, p.two.radius)); }},
               {"the smaller radius", 0,
                [](const Two& p) { return up(std::min(p.one.radius, p.two.radius)); }}};
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
    q.parts = {{"e12", 1, [](const Two& p) { return p.e12(); }},
               {"p1 - p2", 0, [](const Two& p) { return p.between(); }},
               {"p1", 0, [](const Two& p) { return p.one.motion.position; }},
               {"(p1 - p2) / d^2", 0, [](const Two& p) { return times(1 / p.d(), p.e12()); }},
               {"v1 - v2", 0, [](const Two& p) { return p.slip(); }}};
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
    q.parts = {
        {"v1 along e12", 1, [](const Two& p) { return up(dot(p.one.motion.velocity, p.e12())); }},
        {"- v2 along e12", 1,
         [](const Two& p) { return up(-dot(p.two.motion.velocity, p.e12())); }},
        {"(v1 - v2) times the way, not the unit vector", 0,
         [](const Two& p) { return up(p.separation() * p.d()); }},
        {"the size of v1 - v2", 0, [](const Two& p) { return up(length(p.slip())); }}};
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
    const auto d_is_0 = [](const Two& p) { return p.d() == 0 ? "in meet: d is 0 there" : ""; };
    Question<Two> e12 = question("the unit vector e12", "");
    e12.answer = [](const Two& p) { return subject().meet(p.one, p.two).e12; };
    e12.truth = [](const Two& p) { return p.e12(); };
    e12.look_at = "in meet: where d is 0, e12 is (0, 1, 0).";
    e12.zero = d_is_0;
    judge(e12, same);
    Question<Two> q = force_question();
    q.zero = d_is_0;
    q.truth = [](const Two& p) {
      const double both = p.one.radius + p.two.radius;
      return up(push(p.setting, both, p.slip()[1]));
    };
    q.look_at = "the same law, along the e12 that meet() gives there.";
    q.suspects = {};
    judge(q, same);
    std::vector<Two> close = same;  // a small distance is a direction, too
    for (Two& p : close) p.one.motion.position = up(1e-20), p.two.motion.position = {};
    for (std::size_t i = 0; i < close.size(); ++i) {
      if (i % 2 == 0) close[i].one.motion.position = {1e-20, 0, 0};
    }
    Question<Two> small = force_question();
    small.look_at =
        "in meet: only centres that coincide have no direction. A small distance has one.";
    judge(small, close);
  }
  TEST_CASE("all balls: each pair once, equal and opposite") {
    Dice dice(59);
    std::vector<Crowd> crowds;
    for (const int count : {2, 3, 5, 8}) crowds.push_back(crowd_of(dice, count, 0.3));
    judge(crowd_question(), all_of(crowds));
    for (Crowd& crowd : crowds) {  // two of them in the same place
      crowd.balls.back().motion.position = crowd.balls[crowd.balls.size() - 2].motion.position;
    }
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

}  // namespace bounce::check::ball_collision
