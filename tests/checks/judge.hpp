#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "checks/diagnosis.hpp"
#include "checks/subject.hpp"
#include "random_numbers.hpp"

namespace bounce::check {

/// The stage under check.
const Subject& subject();

/// Random, and the same in every run: who writes the example's numbers into the code fails.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return test::uniform(engine_, low, high); }
  double sign() { return between(-1, 1) < 0 ? -1 : 1; }
  Triple triple(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  Triple direction();

 private:
  std::mt19937_64 engine_;
};

/// What learners get wrong: a name, what to say about it, and what such code would answer.
template <class Probe>
struct Suspect {
  std::string mistake;
  std::string advice;
  std::function<Triple(const Probe&)> answers;
};

/// A part of the answer, for diagnose().
template <class Probe>
struct PartOf {
  std::string name;
  double wanted;  // 1; 0 for what is in wrong answers only
  std::function<Triple(const Probe&)> value;
  bool inside = false;  // a piece of another part: without it that is too small
};

/// What is asked of the subject, and how a wrong answer is explained.
template <class Probe>
struct Question {
  std::string tested;  // "the force on the ball"
  std::string unit;
  std::vector<std::string> names;  // of the numbers in an answer that count: {"", "F", ""}
  std::string lesson;              // where to look
  std::function<Triple(const Probe&)> answer;
  std::function<Triple(const Probe&)> truth;
  std::function<double(const Probe&)> rounding;  // how far apart two right answers may be
  std::function<std::string(const Probe&)> where;
  std::function<std::string(const Probe&)> when;  // t and dt
  std::vector<Suspect<Probe>> suspects;
  std::string look_at;                                       // when no suspect explains the answers
  std::function<std::string(const Probe&)> place = nullptr;  // "in contact": where it is asked
  std::vector<PartOf<Probe>> parts = {};
  // What a part may have been multiplied with, or divided by, and should not: {"the mass", ...}
  std::vector<std::pair<std::string, std::function<double(const Probe&)>>> factors = {};
  // "d is 0 there": what could have been divided by; empty: nothing.
  std::function<std::string(const Probe&)> zero = nullptr;
};

/// What the learner reads after the first failure.
struct Finding {
  std::string tested, where, when, got, expected;
  std::string seen;  // where the answers are right, and what the error goes with (diagnosis.hpp)
  std::string mistake, advice, lesson;
};

std::string answer_text(const Triple& answer, const std::vector<std::string>& names,
                        const std::string& unit);
/// Keeps the finding for the reader, and ends the test case.
[[noreturn]] void fail(const Finding& finding);
/// What `fail` kept last.
const Finding& last_finding();

/// What is said of the subject when all checks have passed; empty: nothing more.
void conclude(const std::string& sentence);
const std::string& conclusion();

inline constexpr const char* all_zero = "0 in every case";
inline constexpr const char* not_among_them = "none of the known mistakes";

/// Each part of the right answer, times and divided by what it should not be.
template <class Probe>
void add_products(const Question<Probe>& question, const std::vector<Probe>& probes, Evidence& e) {
  for (const PartOf<Probe>& part : question.parts) {
    if (part.wanted == 0) continue;
    for (const auto& [name, factor] : question.factors) {
      Part more{part.name + " times " + name, 0, {}},
          less{part.name + " divided by " + name, 0, {}};
      for (const Probe& probe : probes) {
        const Triple value = part.value(probe);
        const double by = factor(probe), under = by != 0 ? 1 / by : 0;
        more.value.push_back({value[0] * by, value[1] * by, value[2] * by});
        less.value.push_back({value[0] * under, value[1] * under, value[2] * under});
      }
      e.products.push_back(more);
      e.products.push_back(less);
    }
  }
}

/// What the answers are made of, and the same questions asked once more, in reverse.
template <class Probe>
void look_closer(const Question<Probe>& question, const std::vector<Probe>& probes, Evidence& e) {
  e.again.resize(probes.size());
  for (std::size_t i = probes.size(); i-- > 0;) e.again[i] = question.answer(probes[i]);
  for (const Probe& probe : probes) e.place.push_back(question.place ? question.place(probe) : "");
  for (const PartOf<Probe>& part : question.parts) {
    e.parts.push_back({part.name, part.wanted, {}, part.inside});
    for (const Probe& probe : probes) e.parts.back().value.push_back(part.value(probe));
  }
  add_products(question, probes, e);
}

/// For answers that are no numbers: what is 0 wherever they are none, or else what was never set.
template <class Probe>
void explain_no_number(const Question<Probe>& question, const std::vector<Probe>& probes,
                       const Evidence& e, Finding& finding) {
  std::string zero;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (is_number(e.got[i])) continue;
    zero = question.zero ? question.zero(probes[i]) : "";
    if (zero.empty()) {
      finding.mistake = "a variable that was never given a value";
      finding.advice =
          "`Eigen::Vector3d F;` is not zero, and `double x;` is not 0: begin with F(0, 0, 0). (Or "
          "is it 0 / 0, or the root of a negative number?)";
      return;
    }
  }
  if (!zero.empty()) finding.advice = zero + ", and 0 / 0 is no direction.";
}

/// Asks all probes. If an answer is wrong, the suspect that gives *all* of the subject's answers,
/// the right ones too, is named: not what could be wrong, but what would look just like this.
template <class Probe>
void judge(const Question<Probe>& question, const std::vector<Probe>& probes) {
  Evidence e;
  e.components = question.names;
  std::size_t wrong = probes.size();
  for (const Probe& probe : probes) {
    e.got.push_back(question.answer(probe));
    e.expected.push_back(question.truth(probe));
    e.rounding.push_back(question.rounding(probe));
    const bool right = near(e.got.back(), e.expected.back(), e.rounding.back());
    if (!right) wrong = std::min(wrong, e.got.size() - 1);
  }
  if (wrong == probes.size()) return;

  look_closer(question, probes, e);
  Finding finding{question.tested,
                  question.where(probes[wrong]),
                  question.when(probes[wrong]),
                  answer_text(e.got[wrong], question.names, question.unit),
                  answer_text(e.expected[wrong], question.names, question.unit),
                  diagnose(e),
                  not_among_them,
                  question.look_at,
                  question.lesson};
  const auto explains = [&](const Suspect<Probe>& suspect) {
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (!near(e.got[i], suspect.answers(probes[i]), e.rounding[i])) return false;
    }
    return true;
  };
  const auto is_zero = [](const Triple& answer) { return near(answer, Triple{}, 0); };
  const auto guilty = std::find_if(question.suspects.begin(), question.suspects.end(), explains);
  if (std::all_of(e.got.begin(), e.got.end(), is_zero)) {
    finding.mistake = all_zero;
    finding.advice = "if this gap is still empty, that is why.";
  } else if (guilty != question.suspects.end()) {
    finding.mistake = guilty->mistake;
    finding.advice = guilty->advice;
  } else {
    explain_no_number(question, probes, e, finding);
  }
  fail(finding);
}

}  // namespace bounce::check
