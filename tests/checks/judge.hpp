#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "checks/subject.hpp"

namespace bounce::check {

/// The stage under check.
const Subject& subject();

/// Drawn by lot, and the same in every run: who writes the example's numbers into the code fails.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(engine_);
  }
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
  std::string look_at;  // when no suspect explains the answers
};

/// What the learner reads after the first failure.
struct Finding {
  std::string tested, where, when, got, expected;
  std::string seen;  // where the answers are right, and what the error goes with (diagnosis.hpp)
  std::string mistake, advice, lesson;
};

bool near(const Triple& a, const Triple& b, double tolerance);
std::string answer_text(const Triple& answer, const std::vector<std::string>& names,
                        const std::string& unit);
/// "got / expected = -1 in every case", when the answers go together like that; or nothing.
std::string common_factor(const std::vector<Triple>& got, const std::vector<Triple>& expected);

/// Keeps the finding for the reader, and ends the test case.
[[noreturn]] void fail(const Finding& finding);
/// What `fail` kept last.
const Finding& last_finding();

inline constexpr const char* nothing_written = "nothing written yet";
inline constexpr const char* not_among_them = "none of the known mistakes";

/// Asks all probes. If an answer is wrong, the suspect that gives *all* of the subject's answers,
/// the right ones too, is named: not what could be wrong, but what would look just like this.
template <class Probe>
void judge(const Question<Probe>& question, const std::vector<Probe>& probes) {
  std::vector<Triple> got, expected;
  std::vector<double> rounding;
  std::size_t wrong = probes.size();
  bool all_zero = true;
  for (const Probe& probe : probes) {
    got.push_back(question.answer(probe));
    expected.push_back(question.truth(probe));
    rounding.push_back(question.rounding(probe));
    const bool right = near(got.back(), expected.back(), rounding.back());
    if (!right) wrong = std::min(wrong, got.size() - 1);
    all_zero = all_zero && near(got.back(), Triple{}, 0);
  }
  if (wrong == probes.size()) return;

  Finding finding{question.tested,
                  question.where(probes[wrong]),
                  question.when(probes[wrong]),
                  answer_text(got[wrong], question.names, question.unit),
                  answer_text(expected[wrong], question.names, question.unit),
                  "",
                  not_among_them,
                  question.look_at,
                  question.lesson};
  const auto explains = [&](const Suspect<Probe>& suspect) {
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (!near(got[i], suspect.answers(probes[i]), rounding[i])) return false;
    }
    return true;
  };
  const auto guilty = std::find_if(question.suspects.begin(), question.suspects.end(), explains);
  if (all_zero) {
    finding.mistake = nothing_written;
    finding.advice = "the answer is 0 in every case: this gap is still empty.";
  } else if (guilty != question.suspects.end()) {
    finding.mistake = guilty->mistake;
    finding.advice = guilty->advice;
  } else if (const std::string factor = common_factor(got, expected); !factor.empty()) {
    finding.advice = factor + ". " + finding.advice;
  }
  fail(finding);
}

}  // namespace bounce::check
