#include <doctest/doctest.h>

#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

namespace bounce::check::three_dimensions {
namespace {

Triple weight(const Moment& m) { return up(-m.weight()); }
bool touches(const Moment& m) { return m.setting.floor && m.overlaps(); }
double overlap(const Moment& m) { return m.setting.radius - m.y(); }
Triple right(const Moment& m) {
  return plus(weight(m), up(touches(m) ? push(m.setting, overlap(m), m.v()) : 0));
}

Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q;
  q.tested = tested;
  q.unit = "N";
  q.names = {"Fx", "Fy", "Fz"};
  q.lesson = "docs/04_three_dimensions.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = right;
  q.rounding = force_rounding;
  q.where = [](const Moment& m) { return in_space(m) + (m.setting.floor ? "" : ", no floor"); };
  q.when = one_moment;
  q.look_at = "along y it is the force of stage 3; along x and z there is no force at all.";
  const auto contact = [](const Moment& m) {
    return Contact{up(1), m.setting.radius - m.y(), m.v(), touches(m)};
  };
  q.place = [=](const Moment& m) { return contact_place(contact(m), m.setting.radius); };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself);
  q.factors = force_factors<Moment>(contact, itself);
  q.suspects = {
      {"<= instead of <",
       "a ball that just touches (y = r) has no overlap, so no contact force: y < r.",
       [](const Moment& m) {
         const bool in = m.setting.floor && m.y() <= m.setting.radius;
         return plus(weight(m), up(in ? push(m.setting, overlap(m), m.v()) : 0));
       }},
      {"gravity points up",
       "y is up and gravity pulls downwards: its component along y is negative.",
       [](const Moment& m) { return plus(right(m), weight(m), -2); }},
      {"mass forgotten", "a force is wanted, and gravity alone is an acceleration.",
       [](const Moment& m) { return plus(plus(right(m), weight(m), -1), up(-m.setting.gravity)); }},
      {"z is up", "gravity pulls along z in yours. In this course y is up.",
       [](const Moment& m) {
         const double z = m.motion.position[2], v = m.motion.velocity[2];
         const bool in = m.setting.floor && z < m.setting.radius;
         return Triple{0, 0, -m.weight() + (in ? push(m.setting, m.setting.radius - z, v) : 0)};
       }},
      {"gravity along all three", "gravity has a component along y only: (0, -m g, 0).",
       [](const Moment& m) {
         return plus(plus(right(m), weight(m), -1), Triple{1, 1, 1}, -m.weight());
       }},
      {"damper on all three components",
       "the floor is frictionless: the damper brakes the velocity along y and leaves x and z "
       "alone.",
       [](const Moment& m) {
         const Triple all =
             plus(up(m.setting.stiffness * overlap(m)), m.motion.velocity, -m.setting.damping);
         return touches(m) ? plus(weight(m), all) : weight(m);
       }},
      {"spring on all three components",
       "the floor pushes along its normal, which is y. There is no push along x and z.",
       [](const Moment& m) {
         const double p = touches(m) ? push(m.setting, overlap(m), m.v()) : 0;
         return plus(weight(m), Triple{1, 1, 1}, p);
       }},
      {"no floor where there is one, or one where there is none",
       "`floor` says whether there is a floor: without it there is gravity only.",
       [](const Moment& m) {
         return plus(weight(m), up(m.overlaps() ? push(m.setting, overlap(m), m.v()) : 0));
       }},
      {"no floor where there is one, or one where there is none",
       "`floor` says whether there is a floor; yours has none.",
       [](const Moment& m) { return weight(m); }},
      {"the weight is gone in contact",
       "in contact there is the push only. Forces add up: force.y() += push.",
       [](const Moment& m) {
         return touches(m) ? up(push(m.setting, overlap(m), m.v())) : weight(m);
       }},
      {"the damper has the wrong sign", "a brake points against the velocity: - c v.",
       [](const Moment& m) {
         return plus(weight(m), up(touches(m) ? push(m.setting, overlap(m), -m.v()) : 0));
       }},
      {"push_only forgotten", "with contact push_only the push is std::max(0.0, spring + damper).",
       [](const Moment& m) {
         Setting s = m.setting;
         s.push_only = false;
         return plus(weight(m), up(touches(m) ? push(s, overlap(m), m.v()) : 0));
       }}};
  const auto limited = limits_the_weight(contact);
  q.suspects.insert(q.suspects.end(), limited.begin(), limited.end());
  return q;
}

std::vector<Moment> moments(unsigned seed, double least, double most, int kinds) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 24; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.push_only = kinds > 1 && i % 2 == 1;
    s.floor = kinds < 3 || i % 3 != 0;
    Motion motion{dice.triple(2), dice.triple(9)};
    const bool deep = i % 4 == 2 && least > 0;  // the whole ball is below the floor
    motion.position[1] = s.radius - s.radius * dice.between(least, deep ? 40 : most);
    all.push_back({s, dice.between(0, 3), motion});
  }
  return all;
}

}  // namespace

TEST_SUITE("04_three_dimensions") {
  TEST_CASE("in the air gravity acts, along y only") {
    judge(force_question("the force on a ball that does not touch"), moments(41, -9, -0.01, 1));
  }
  TEST_CASE("the floor pushes along y only: it is frictionless") {
    judge(force_question("the force on a ball that overlaps the floor"), moments(42, 0.01, 1.5, 1));
  }
  TEST_CASE("both kinds of contact, with a floor and without") {
    judge(force_question("the force on a ball"), moments(43, -0.2, 0.5, 3));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(44, 0, 0, 1);
    for (Moment& m : edge) m.motion.position[1] = m.setting.radius;
    judge(force_question("the force on a ball at exactly y = r"), edge);
  }
  TEST_CASE("the acceleration is force / mass, in all three components") {
    Question<Moment> q = force_question("the ball's acceleration");
    q.unit = "m/s^2";
    q.names = {"ax", "ay", "az"};
    q.answer = [](const Moment& m) { return subject().acceleration(m.setting, m.t, m.motion); };
    q.truth = [](const Moment& m) { return times(1 / m.setting.mass, right(m)); };
    q.rounding = [](const Moment& m) { return 2 * force_rounding(m) / m.setting.mass; };
    q.look_at = "a = F / m, for the whole vector at once.";
    q.parts.clear();  // of the force
    q.parts.push_back({"F / m", 1, q.truth});
    q.parts.push_back({"F", 0, right});
    q.parts.push_back({"F m", 0, [](const Moment& m) { return times(m.setting.mass, right(m)); }});
    q.suspects = {{"mass forgotten", "this is the force itself. Divide it by the mass.", right},
                  {"multiplied by the mass", "F = m a, so a = F / m: divide.",
                   [](const Moment& m) { return times(m.setting.mass, right(m)); }}};
    judge(q, moments(45, -1, 1, 3));
  }
  TEST_CASE("the ball falls, bounces once, and is where the formula says, for several dt") {
    Dice dice(46);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
      runs.push_back(bounce_run(s, up(1), dice.between(0.3, 1.5), dt));
    }
    judge_runs("docs/04_three_dimensions.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::three_dimensions
