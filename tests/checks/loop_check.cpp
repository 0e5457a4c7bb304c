// A better loop: a learner's own method (mine_method.hpp).
#include <doctest/doctest.h>

#include <cmath>

#include "checks/law.hpp"
#include "checks/loop_known.hpp"
#include "checks/loop_measured.hpp"

using namespace bounce::check;

namespace {

constexpr const char* lesson = "docs/deeper/02_spring_floor.md, \"A better loop\"";
constexpr double least_order = 2, rounding_of_order = 0.1, most_evaluations = 8;

/// What fails that is no single answer. A mistake is named if it does the same at every step.
void refuse(Finding finding) {
  finding.lesson = lesson;
  if (finding.mistake.empty()) finding.mistake = not_among_them;
  if (const KnownMethod* mistake = find_twin(usual_mistakes())) {
    finding.mistake = mistake->name;
    finding.advice = mistake->says;
  }
  fail(finding);
}

/// A fall without air, of some steps.
struct Fall {
  double g, y, v, dt;
  long steps;
  double end() const { return dt * static_cast<double>(steps); }
  Walk walk() const {
    return {[g = g](double, double, double) { return -g; }, 0.3, y, v, dt, steps};
  }
};
Triple y_and_v(double y, double v) { return {y, v, 0}; }
Triple change(const Fall& fall, const Walked& walked) {
  const Walked::Noted& end = walked.states.back();
  return y_and_v(end.y - fall.y, end.v - fall.v);
}

Question<Fall> fall_question() {
  Question<Fall> q;
  q.tested = "how far the ball got in free fall, and how much faster";
  q.names = {"y changed by [m]", "v changed by [m/s]", ""};
  q.lesson = lesson;
  q.answer = [](const Fall& f) { return change(f, subject().walk(f.walk())); };
  q.truth = [](const Fall& f) {
    return y_and_v(f.v * f.end() - f.g * f.end() * f.end() / 2, -f.g * f.end());
  };
  q.rounding = [](const Fall&) { return 1e-11; };  // numbers up to 500, rounded 60 times
  q.where = [](const Fall& f) {
    return std::to_string(f.steps) + (f.steps == 1 ? " step" : " steps") +
           " from y = " + number(f.y) + " m, v = " + number(f.v) + " m/s; gravity " + number(f.g);
  };
  q.when = [](const Fall& f) { return "dt = " + number(f.dt) + " s"; };
  q.look_at = "y changes by v t - g t^2 / 2 and v by -g t, in one step as in many.";
  q.parts = {{"v t (in y)", 1, [](const Fall& f) { return y_and_v(f.v * f.end(), 0); }},
             {"g t^2 / 2 (in y)", 1,
              [](const Fall& f) { return y_and_v(-f.g * f.end() * f.end() / 2, 0); }},
             {"g t (in v)", 1, [](const Fall& f) { return y_and_v(0, -f.g * f.end()); }},
             {"g t dt (in y)", 0, [](const Fall& f) { return y_and_v(f.g * f.end() * f.dt, 0); }}};
  if (const KnownMethod* mistake = find_twin(usual_mistakes())) {
    q.suspects = {{mistake->name, mistake->says,
                   [mistake](const Fall& f) { return change(f, mistake->walk(f.walk())); }}};
  }
  return q;
}

/// A ball in space, each coordinate under the same law, as three on a line.
struct InSpace {
  Walk walk;
  Motion start;
  double alone(int i) const {
    Walk one = walk;
    one.y = start.position.at(static_cast<std::size_t>(i));
    one.v = start.velocity.at(static_cast<std::size_t>(i));
    return subject().walk(one).states.back().y;
  }
};

std::string measured(const char* format, double value) {
  char text[60];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The least order of all cases in which it must be 2.
double order_without_damper() {
  double order = 1e9;
  for (const SmoothCase& one : undamped_cases()) order = std::min(order, measured_order(one));
  return order;
}

std::string energy_text(const Energies& energies) {
  const double off = std::max(energies.most - 1, 1 - energies.least), drift = energies.last - 1;
  const std::string in = " in 10 000 swings of a spring, 157 steps each";
  if (off < 0.01) return "keeps the energy to " + measured("%.1g %%", 100 * off) + in;
  return (drift > 0 ? "gains " : "loses ") + measured("%.0f %%", 100 * std::abs(drift)) +
         " of energy" + in;
}

std::string name_text() {
  if (const KnownMethod* twin = find_twin(built_in_methods())) {
    return (is_twin(*twin, true) ? "it is " : "without a damper it is ") + twin->name +
           ", or its twin";
  }
  if (const KnownMethod* twin = find_twin(methods_of_textbooks())) {
    return "the course has none like it; it is " + twin->name + ", or its twin";
  }
  return "it does what no method of the course does";
}

std::string verdict_text() {
  const double order = order_without_damper(), damped = measured_order(damped_case());
  const double calls = evaluations_a_step();
  std::string text = "Your method is of order " + measured("%.2f", order);
  if (damped < order - 0.5) text += measured(" (%.2f with a damper)", damped);
  text += ", " + energy_text(energies_of_swings()) + ", and costs " + measured("%.3g", calls) +
          (calls == 1 ? " force evaluation a step: " : " force evaluations a step: ");
  return text + name_text() + ".";
}

}  // namespace

TEST_SUITE("loop") {
  TEST_CASE("in free fall it is where the formula says, whatever dt is") {
    Dice dice(91);
    std::vector<Fall> falls;
    for (const double dt : {1e-3, 0.03, 0.2, 0.5}) {
      for (const long steps : {1, 2, 17}) {
        falls.push_back({dice.between(2, 20), dice.between(1, 9), dice.between(1, 5), dt, steps});
      }
    }
    judge(fall_question(), falls);
  }

  TEST_CASE("it moves a vector as it moves each of its numbers") {
    Question<InSpace> q;
    q.tested = "where a ball in space is after some steps, against three balls on a line";
    q.unit = "m";
    q.names = {"x", "y", "z"};
    q.lesson = lesson;
    q.answer = [](const InSpace& s) { return subject().walk_in_space(s.walk, s.start).position; };
    q.truth = [](const InSpace& s) { return Triple{s.alone(0), s.alone(1), s.alone(2)}; };
    q.rounding = [](const InSpace&) { return 1e-12; };  // the same sums
    q.where = [](const InSpace& s) { return "from " + numbers(s.start.position) + " m"; };
    q.when = [](const InSpace& s) {
      return "steps: " + std::to_string(s.walk.steps) + ", dt = " + number(s.walk.dt) + " s";
    };
    q.look_at =
        "a number is moved in another way than a vector. Is there an `auto` or an `&`? Then an "
        "acceleration is lost when you ask for the next one: keep it in a `Vector` of its own.";
    std::vector<InSpace> balls;
    Dice dice(92);
    for (const long steps : {1, 2, 9}) {
      const auto law = [](double t, double y, double v) {
        return std::cos(3 * t) - 4 * y * y * y - 0.3 * v;
      };
      balls.push_back({{law, 0.2, 0, 0, 0.05, steps}, {dice.triple(1), dice.triple(1)}});
    }
    judge(q, balls);
  }

  TEST_CASE("with half of the dt, a quarter of the error or less: order 2") {
    for (const SmoothCase& one : undamped_cases()) {
      const double order = measured_order(one);
      if (order >= least_order - rounding_of_order) continue;
      Finding finding;
      finding.tested = "the order, by least squares over twelve dt, " + one.name;
      finding.got = std::isnan(order) ? "no order: the error is not a number"
                                      : "order " + measured("%.2f", order);
      finding.expected = "order 2 or more";
      finding.advice =
          "what the second half of a step goes by: it needs an acceleration from "
          "there, at its own time and place.";
      refuse(finding);
    }
  }

  TEST_CASE("it asks for the acceleration at most 8 times a step") {
    const double calls = evaluations_a_step();
    if (calls <= most_evaluations) return;
    Finding finding;
    finding.tested = "how often the scene's acceleration is asked for";
    finding.got = measured("%.4g times a step", calls);
    finding.expected = "at most 8 times";
    finding.mistake = "too many evaluations";
    finding.advice =
        "many small steps in one are no better method: they are a smaller dt, at "
        "its price.";
    refuse(finding);
  }

  TEST_CASE("on a spring floor it still bounces after 10 000 bounces") {
    const Energies energies = energies_of_bounces();
    if (energies.least > 0.5 && energies.most < 2) return conclude(verdict_text());
    Finding finding;
    finding.tested = "the energy of a ball on a spring floor without a damper";
    finding.when = "dt = " + number(energy_dt) + " s, in the time of 10 000 bounces";
    finding.got = "between " + measured("%.3g", energies.least) + " and " +
                  measured("%.3g times the energy of the start", energies.most);
    finding.expected = "between half and twice the energy of the start";
    finding.advice =
        "where the floor begins: the force is 0 before and not after. Does your "
        "method remember something that no longer holds?";
    refuse(finding);
  }
}
