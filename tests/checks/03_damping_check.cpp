#include <doctest/doctest.h>

#include "checks/force_parts.hpp"
#include "checks/run_check.hpp"

namespace bounce::check::damping {
namespace {

double spring(const Moment& m) { return m.setting.stiffness * (m.setting.radius - m.y()); }
double damper(const Moment& m) { return -m.setting.damping * m.v(); }
double contact(const Moment& m) {
  return m.overlaps() ? push(m.setting, m.setting.radius - m.y(), m.v()) : 0;
}
double right(const Moment& m) { return -m.weight() + contact(m); }
double clamped(const Moment& m, double force) {
  return m.setting.push_only ? std::max(0.0, force) : force;
}

Question<Moment> force_question(const std::string& tested) {
  Question<Moment> q;
  q.tested = tested;
  q.unit = "N";
  q.names = {"", "F", ""};
  q.lesson = "docs/03_damping.md, \"The idea\"";
  q.answer = [](const Moment& m) { return subject().force(m.setting, m.t, m.motion); };
  q.truth = [](const Moment& m) { return up(right(m)); };
  q.rounding = force_rounding;
  q.where = on_a_line;
  q.when = one_moment;
  q.look_at = "F = -m g, and while y < r also + k (r - y) - c v.";
  const auto contact = [](const Moment& m) {
    return Contact{up(1), m.setting.radius - m.y(), m.v(), m.overlaps()};
  };
  q.place = [=](const Moment& m) { return contact_place(contact(m), m.setting.radius); };
  const auto itself = [](const Moment& m) { return m; };
  q.parts = force_parts<Moment>(contact, itself, true);
  q.factors = force_factors<Moment>(contact, itself);
  q.suspects = {
      {"<= instead of <",
       "a ball that just touches (y = r) has no overlap, so no contact force: y < r.",
       [](const Moment& m) {
         const bool touches = m.y() <= m.setting.radius;
         return up(-m.weight() + (touches ? clamped(m, spring(m) + damper(m)) : 0));
       }},
      {"gravity points up", "y counts upwards, gravity pulls downwards: -mass * gravity.",
       [](const Moment& m) { return up(right(m) + 2 * m.weight()); }},
      {"mass forgotten",
       "a force is wanted, and gravity alone is an acceleration: -mass * gravity.",
       [](const Moment& m) { return up(right(m) + m.weight() - m.setting.gravity); }},
      {"damper always on",
       "the damper brakes in the air, too. It is part of the floor: only while y < r.",
       [](const Moment& m) {
         return up(-m.weight() + clamped(m, (m.overlaps() ? spring(m) : 0) + damper(m)));
       }},
      {"damper always on",
       "the damper brakes in the air, too. It is part of the floor: only while y < r.",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? clamped(m, spring(m) + damper(m)) : damper(m)));
       }},
      {"the damper has the wrong sign",
       "it drives the ball on. A brake points against the velocity: - c v.",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? clamped(m, spring(m) - damper(m)) : 0));
       }},
      {"the damper does not turn around",
       "yours is the same on the way in and on the way out. The velocity has a sign: - c v, not - "
       "c |v|.",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? clamped(m, spring(m) - std::abs(damper(m))) : 0));
       }},
      {"no damper", "this is stage 2. While they overlap, add - c v to the spring.",
       [](const Moment& m) { return up(-m.weight() + (m.overlaps() ? spring(m) : 0)); }},
      {"the spring on the wrong side", "the spring pushes upwards, with + k (r - y).",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? clamped(m, -spring(m) + damper(m)) : 0));
       }},
      {"push_only forgotten",
       "with contact push_only your floor still pulls. There the push is std::max(0.0, spring + "
       "damper); "
       "docs/deeper/03_damping.md says why, in \"The damper can pull\".",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? spring(m) + damper(m) : 0));
       }},
      {"push_only limits the weight, too",
       "the limit is for the push of spring and damper only; gravity stays: take std::max(0.0, "
       "push) "
       "before you add it to the force.",
       [](const Moment& m) {
         return up(m.overlaps() ? clamped(m, -m.weight() + spring(m) + damper(m)) : -m.weight());
       }},
      {"push_only limits the weight, too",
       "the limit is for the push of spring and damper only; gravity stays: take std::max(0.0, "
       "push) "
       "before you add it to the force.",
       [](const Moment& m) {
         return up(clamped(m, -m.weight() + (m.overlaps() ? spring(m) + damper(m) : 0)));
       }},
      {"push_only whatever the contact",
       "with contact may-pull the floor may pull. Only if contact == ContactLaw::push_only is the "
       "push "
       "at least 0.",
       [](const Moment& m) {
         return up(-m.weight() + (m.overlaps() ? std::max(0.0, spring(m) + damper(m)) : 0));
       }},
      {"push_only takes the damper away",
       "the damper is there with both contacts. push_only only says that spring and damper "
       "together "
       "never pull.",
       [](const Moment& m) {
         return up(-m.weight() +
                   (m.overlaps() ? spring(m) + (m.setting.push_only ? 0 : damper(m)) : 0));
       }},
      {"push_only pulls only",
       "min for max: the push is the *larger* one of 0 and spring + damper.",
       [](const Moment& m) {
         const double p = spring(m) + damper(m);
         return up(-m.weight() + (!m.overlaps() ? 0 : m.setting.push_only ? std::min(0.0, p) : p));
       }},
      {"push_only turns the pull around",
       "where spring and damper would pull, the push is 0: std::max(0.0, push), not its size.",
       [](const Moment& m) {
         const double p = spring(m) + damper(m);
         return up(-m.weight() + (!m.overlaps() ? 0 : m.setting.push_only ? std::abs(p) : p));
       }},
      {"damping times the position",
       "the damper brakes the velocity: damping * v, and v is state.velocity.",
       [](const Moment& m) {
         return up(-m.weight() +
                   (m.overlaps() ? clamped(m, spring(m) - m.setting.damping * m.y()) : 0));
       }},
      {example_numbers, example_advice,
       [](const Moment& m) { return up(right(as_in_the_example(m))); }}};
  return q;
}

enum Contacts { may_pull_only, push_only_too };

std::vector<Moment> moments(unsigned seed, double least, double most, Contacts contacts) {
  Dice dice(seed);
  std::vector<Moment> all;
  for (int i = 0; i < 24; ++i) {
    Setting s = any_setting(dice);
    s.damping = dice.between(1, 300);
    s.push_only = contacts == push_only_too && i % 3 != 0;
    // Some are deep: the whole ball is below the floor, or came through it.
    const bool deep = i % 4 == 3 && least > 0;
    const double overlap = s.radius * dice.between(least, deep ? 40 : most);
    all.push_back({s,
                   dice.between(0, 3),
                   {up(s.radius - overlap), up(i % 8 == 5 ? 0 : dice.between(-9, 9))}});
  }
  return all;
}

}  // namespace

TEST_SUITE("03_damping") {
  TEST_CASE("away from the floor only gravity acts: no spring, no damper") {
    judge(force_question("the force on a ball that does not touch"),
          moments(31, -9, -0.01, may_pull_only));
  }
  TEST_CASE("while they overlap, spring and damper: k (r - y) - c v") {
    judge(force_question("the force on a ball that overlaps the floor"),
          moments(32, 0.01, 1.5, may_pull_only));
  }
  TEST_CASE("contact push_only: the push is never below 0, and gravity stays") {
    judge(force_question("the force on a ball, with both kinds of contact"),
          moments(33, -0.2, 0.4, push_only_too));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(34, 0, 0, may_pull_only);
    for (Moment& m : edge) m.motion.position = up(m.setting.radius);
    judge(force_question("the force on a ball at exactly y = r"), edge);
  }
  TEST_CASE("the ball falls, bounces once, and is where the formula says, for several dt") {
    Dice dice(35);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      for (const bool push_only : {false, true}) {
        Setting s = any_setting(dice);
        s.push_only = push_only;
        s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
        runs.push_back(bounce_run(s, up(1), dice.between(0.3, 1.5), dt));
      }
    }
    judge_runs("docs/03_damping.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::damping
