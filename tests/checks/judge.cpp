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

std::string answer_text(const Triple& answer, const std::vector<std::string>& names,
                        const std::string& unit) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    if (names.at(i).empty()) continue;
    if (!text.empty()) text += ", ";
    text += names[i] + " = ";
    text += std::isnan(answer[i]) ? "not a number" : to_rounded_text(answer[i], 6);
  }
  return text + (unit.empty() ? "" : " " + unit);
}

static Finding& kept() {
  static Finding finding;
  return finding;
}
const Finding& last_finding() { return kept(); }

static std::string& concluded() {
  static std::string sentence;
  return sentence;
}
void conclude(const std::string& sentence) { concluded() = sentence; }
const std::string& conclusion() { return concluded(); }

void fail(const Finding& finding) {
  kept() = finding;
  FAIL(finding.tested, ": got ", finding.got, ", expected ", finding.expected, "; ",
       finding.advice);
  throw finding;  // not reached: FAIL ends the test case
}

}  // namespace bounce::check
