#include "checks/07_tilted_plane_questions.hpp"

#include <doctest/doctest.h>

namespace bounce::check::tilted_plane {

TEST_SUITE("07_tilted_plane") {
  TEST_CASE("the normal gets length 1") {
    Question<Moment> q = plane_question();
    q.tested = "the normal of plane()";
    q.names = {"a", "b", "c"};
    q.answer = [](const Moment& m) {
      const auto plane = subject().plane(m.setting);
      return Triple{plane[0], plane[1], plane[2]};
    };
    q.truth = [](const Moment& m) { return unit(m).n; };
    q.look_at = "divide the normal by its length.";
    q.parts = {{"the normal divided by its length", 1, [](const Moment& m) { return unit(m).n; }},
               {"the normal as it is given", 0, [](const Moment& m) { return m.setting.normal; }},
               {"the normal divided by its largest part", 0,
                [](const Moment& m) {
                  const Triple& n = m.setting.normal;
                  return times(1 / std::max({n[0], n[1], n[2]}), n);
                }},
               {"the normal divided by a + b + c", 0, [](const Moment& m) {
                  const Triple& n = m.setting.normal;
                  return times(1 / (n[0] + n[1] + n[2]), n);
                }}};
    q.suspects = {{"normal not normalised", "its length is not 1. Divide it by normal.norm().",
                   [](const Moment& m) { return m.setting.normal; }},
                  {"divided by the length twice", "divide by the length, not by its square.",
                   [](const Moment& m) {
                     const Triple& n = m.setting.normal;
                     return times(1 / dot(n, n), n);
                   }}};
    judge(q, moments(71, 0, 1, false));
  }
  TEST_CASE("the offset is divided by the same length") {
    Question<Moment> q = plane_question();
    q.tested = "the offset of plane()";
    q.unit = "m";
    q.names = {"", "d", ""};
    q.answer = [](const Moment& m) { return up(subject().plane(m.setting)[3]); };
    q.truth = [](const Moment& m) { return up(unit(m).d); };
    q.look_at = "both sides of the equation are divided by the length of the normal.";
    q.parts = {
        {"the offset divided by the length", 1, [](const Moment& m) { return up(unit(m).d); }},
        {"the offset as it is given", 0, [](const Moment& m) { return up(m.setting.offset); }},
        {"the offset times the length", 0,
         [](const Moment& m) { return up(m.setting.offset * length(m.setting.normal)); }},
        {"the offset divided by the length twice", 0,
         [](const Moment& m) { return up(unit(m).d / length(m.setting.normal)); }}};
    q.suspects = {
        {"offset not normalised",
         "the normal is divided by its length and the offset is not, so it is another plane.",
         [](const Moment& m) { return up(m.setting.offset); }},
        {"the offset's sign", "the equation is n . p + d = 0: d keeps its sign.",
         [](const Moment& m) { return up(-unit(m).d); }}};
    judge(q, moments(72, 0, 1, false));
  }
  TEST_CASE("away from the plane only gravity acts") {
    judge(force_question("the force on a ball that does not touch"), moments(73, 1.01, 9, false));
  }
  TEST_CASE("in contact the push is along the normal, and the damper brakes n . v only") {
    judge(force_question("the force on a ball that overlaps the plane"),
          moments(74, 0.1, 0.99, false));
  }
  TEST_CASE("a ball whose centre is behind the plane is pushed back") {
    judge(force_question("the force on a ball that is deep in the plane"),
          moments(75, -2, -0.1, false));
  }
  TEST_CASE("both kinds of contact") {
    judge(force_question("the force on a ball"), moments(76, 0.7, 1.1, true));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(77, 0, 0, false);
    for (Moment& m : edge) {  // a plane whose distances add up without rounding
      m.setting.normal = {0, 2, 0};
      m.setting.offset = -0.5;
      m.setting.radius = 0.5;
      m.motion.position[1] = 0.75;
    }
    Question<Moment> q = force_question("the force on a ball at exactly distance r");
    q.suspects = {{"<= instead of <", "a ball that just touches has no overlap: distance < r.",
                   [](const Moment& m) {
                     return up(-m.weight() + push(m.setting, 0, m.motion.velocity[1]));
                   }}};
    judge(q, edge);
  }
  TEST_CASE("the ball bounces once and is as far from the plane as the formula says") {
    Dice dice(78);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
      Triple n = dice.direction();
      n[1] = 1 + std::abs(n[1]);
      n = times(1 / length(n), n);
      s.normal = times(dice.between(0.5, 3), n);
      runs.push_back(bounce_run(s, n, dice.between(0.3, 1.5), dt));
    }
    judge_runs("docs/07_tilted_plane.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::tilted_plane
