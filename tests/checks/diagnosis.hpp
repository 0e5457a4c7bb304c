#pragma once
#include <string>
#include <vector>

#include "checks/subject.hpp"

namespace bounce::check {

/// A part of which the right answer is made, or a wrong one could be.
struct Part {
  std::string name;           // "the spring k (r - y)"
  double wanted;              // how many times it is in the right answer: 1, or 0
  std::vector<Triple> value;  // for each question
  bool inside = false;        // a piece of another part: without it that is too small
};

/// All that was asked in one check, and what came back.
struct Evidence {
  std::vector<Triple> got, again, expected;  // `again`: the same questions a second time
  std::vector<double> rounding;              // how far two right answers may be apart
  std::vector<std::string> place;            // "in the air", for each question
  std::vector<std::string> components;       // what x, y and z are called; empty: not asked
  std::vector<Part> parts;
  std::vector<Part> products;  // a part times or divided by what it should not be
};

bool near(const Triple& a, const Triple& b, double tolerance);
/// What was never given a value is "not a number", or larger than any answer (judged_flags).
bool is_number(const Triple& answer);

/// Where the answers are right and where they are wrong, and of what the wrong ones are made. Each
/// sentence holds for all of the answers of which it speaks: what fits only roughly is not said.
std::string diagnose(const Evidence& evidence);

}  // namespace bounce::check
