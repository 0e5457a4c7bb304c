#include <doctest/doctest.h>

#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

namespace bounce::check::spring_floor {
namespace {

double spring(const Moment& m) { return m.setting.stiffness * (m.setting.radius - m.y()); }
double right(const Moment& m) { return -m.weight() + (m.overlaps() ? spring(m) : 0); }

Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q;
  q.tested = tested;
  q.unit = "N";
  q.names = {"", "F", ""};
  q.lesson = "docs/02_spring_floor.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = [](const Moment& m) { return up(right(m)); };
  q.rounding = force_rounding;
  q.where = on_a_line;
  q.when = one_moment;
  q.look_at = "F = -m g, and while y < r also + k (r - y).";
  const auto contact = [](const Moment& m) {
    return Contact{up(1), m.setting.radius - m.y(), m.v(), m.overlaps()};
  };
  q.place = [=](const Moment& m) { return contact_place(contact(m), m.setting.radius); };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself, true);
  q.factors = force_factors<Moment>(contact, itself);
  q.suspects = {
      {"gravity points up", "y counts upwards, gravity pulls downwards: -mass * gravity.",
       [](const Moment& m) { return up(right(m) + 2 * m.weight()); }},
      {"mass forgotten",
       "a force is wanted, and gravity alone is an acceleration: -mass * gravity.",
       [](const Moment& m) { return up(right(m) + m.weight() - m.setting.gravity); }},
      {"the spring in place of gravity",
       "in contact the weight is gone. Forces add up: force += ..., not force = ...",
       [](const Moment& m) { return up(m.overlaps() ? spring(m) : -m.weight()); }},
      {"gravity forgotten", "the ball has its weight everywhere, on the floor too.",
       [](const Moment& m) { return up(right(m) + m.weight()); }},
      {"the spring pulls outside contact",
       "above the floor the spring is stretched and pulls the ball down. A floor does not: only "
       "while y < r.",
       [](const Moment& m) { return up(-m.weight() + spring(m)); }},
      {"y < 0 instead of y < r",
       "the spring starts when the ball's centre reaches the floor. Its lower edge gets there a "
       "radius earlier: while y < r.",
       [](const Moment& m) { return up(-m.weight() + (m.y() < 0 ? spring(m) : 0)); }},
      {"y < 0 instead of y < r",
       "contact and overlap are counted from the ball's centre, as if it had no radius: while y < "
       "r, the overlap is r - y.",
       [](const Moment& m) {
         return up(-m.weight() + (m.y() < 0 ? -m.setting.stiffness * m.y() : 0));
       }},
      {"the radius forgotten", "the overlap is r - y: the radius is missing in yours.",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? -m.setting.stiffness * m.y() : 0));
       }},
      {"the spring on the wrong side",
       "the spring pulls the ball in. It pushes upwards, with + k (r - y): positive while they "
       "overlap.",
       [](const Moment& m) { return up(-m.weight() - (m.overlaps() ? spring(m) : 0)); }},
      {"no spring",
       "this is gravity alone. While the ball overlaps the floor a spring pushes, too.",
       [](const Moment& m) { return up(-m.weight()); }},
      {"a whole number in place of a double",
       "the overlap is cut to whole metres: an `int` where a `double` should be.",
       [](const Moment& m) {
         return up(-m.weight() +
                   (m.overlaps() ? m.setting.stiffness * std::trunc(m.setting.radius - m.y()) : 0));
       }},
      {"the diameter in place of the radius",
       "contact begins a radius above the floor: y < r, and the overlap is r - y, not 2 r - y.",
       [](const Moment& m) {
         const double overlap = 2 * m.setting.radius - m.y();
         return up(-m.weight() + (overlap > 0 ? m.setting.stiffness * overlap : 0));
       }},
      {example_numbers, example_advice,
       [](const Moment& m) { return up(right(as_in_the_example(m))); }}};
  return q;
}

/// Balls whose overlap with the floor is between `least` and `most` radii.
std::vector<Moment> moments(unsigned seed, double least, double most) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 24; ++i) {
    const Setting s = any_setting(dice);
    // Some are deep: the whole ball is below the floor, or came through it.
    const double overlap = s.radius * dice.between(least, i % 4 == 3 && least > 0 ? 40 : most);
    all.push_back({s, dice.between(0, 3), {up(s.radius - overlap), up(dice.between(-5, 5))}});
  }
  return all;
}

}  // namespace

TEST_SUITE("02_spring_floor") {
  TEST_CASE("away from the floor only gravity acts") {
    judge(force_question("the force on a ball that does not touch"), moments(21, -9, -0.01));
  }
  TEST_CASE("while they overlap, a spring pushes up with k times the overlap") {
    judge(force_question("the force on a ball that overlaps the floor"), moments(22, 0.01, 2));
  }
  TEST_CASE("the ball falls, bounces once, and is where the formula says, for several dt") {
    Dice dice(23);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      runs.push_back(bounce_run(any_setting(dice), up(1), dice.between(0.3, 1.5), dt));
    }
    judge_runs("docs/02_spring_floor.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::spring_floor
