// What ./course check 3 asks. Each question is asked for random numbers, so that only a law passes,
// and no example.
#include <doctest/doctest.h>

#include "checks/law.hpp"

using namespace bounce::check;

namespace {

/// The right answer [N], written a second time, from the lesson: not a copy of the stage's code.
double right(const Moment& m) {
  const Setting& s = m.setting;
  const double contact = m.overlaps() ? push(s, s.radius - m.y(), m.v()) : 0;
  return contact - s.mass * s.gravity;
}

/// Half of the balls are in the air, half in contact; some rise, some fall.
std::vector<Moment> moments() {
  Dice dice(3);
  std::vector<Moment> all;
  for (int i = 0; i < 40; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.push_only = i % 4 == 1;
    const double height = s.radius * dice.between(i % 2 == 0 ? 1 : 0, i % 2 == 0 ? 9 : 1);
    all.push_back({s, 0, {up(height), up(dice.between(-9, 9))}});
  }
  return all;
}

Question<Moment> force_question() {
  Question<Moment> q;
  q.tested = "the force on the ball";
  q.unit = "N";
  q.names = {"", "F", ""};
  q.lesson = "docs/03_damping.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = [](const Moment& m) { return up(right(m)); };
  q.rounding = force_rounding;
  q.where = on_a_line;
  q.when = one_moment;
  q.look_at = "F = -m g, and while y < r also k (r - y) - c v.";
  // What a learner may get wrong: its name, what to say, and what such code would answer.
  q.suspects = {{"the damper has the wrong sign",
                 "it drives the ball on. A brake points against the velocity: - c v.",
                 [](Moment m) {
                   m.setting.damping *= -1;
                   return up(right(m));
                 }},
                {"gravity points up", "y counts upwards, gravity pulls downwards.",
                 [](const Moment& m) { return up(right(m) + 2 * m.weight()); }}};
  return q;
}

}  // namespace

TEST_SUITE("03_damping") {
  TEST_CASE("the force on the ball, in the air and in contact") {
    judge(force_question(), moments());
  }
}
