#include "checks/judge.hpp"

#include <doctest/doctest.h>

#include "physics/text.hpp"

namespace bounce::check {

Triple Dice::direction() {
  for (;;) {
    const Triple t = triple(1);
    const double length = std::hypot(t[0], t[1], t[2]);
    if (length > 0.1 && length < 1) return {t[0] / length, t[1] / length, t[2] / length};
  }
}

bool near(const Triple& a, const Triple& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;  // "not a number" is near nothing
  }
  return true;
}

std::string answer_text(const Triple& answer, const std::vector<std::string>& names,
                        const std::string& unit) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    if (names.at(i).empty()) continue;
    if (!text.empty()) text += ", ";
    text += names[i] + " = " + to_rounded_text(answer[i], 6);
  }
  return text + (unit.empty() ? "" : " " + unit);
}

std::string common_factor(const std::vector<Triple>& got, const std::vector<Triple>& expected) {
  double factor = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (got[i][j] == 0 && expected[i][j] == 0) continue;
      const double here = got[i][j] / expected[i][j];
      if (factor == 0) factor = here;
      if (!(std::abs(here - factor) <= 1e-6 * std::abs(factor))) return "";
    }
  }
  if (factor == 0 || !std::isfinite(factor)) return "";
  return "your answer is " + to_rounded_text(factor, 4) + " times the expected one in every case";
}

static Finding& kept() {
  static Finding finding;
  return finding;
}
const Finding& last_finding() { return kept(); }

void fail(const Finding& finding) {
  kept() = finding;
  FAIL(finding.tested, ": got ", finding.got, ", expected ", finding.expected, "; ",
       finding.advice);
  throw finding;  // not reached: FAIL ends the test case
}

}  // namespace bounce::check
