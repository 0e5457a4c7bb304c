#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "docs/lesson_tool.hpp"
#include "physics/text.hpp"

namespace bounce::test {

/// What only an author can mend.
struct Mistake : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::vector<std::string> output_of(const std::string& command, const Runner& run);

/// The same paragraph, with its `<!-- value: ... -->` lines on top, as the programs have it now.
std::vector<std::string> with_values(const std::vector<std::string>& paragraph, const Runner& run);

/// The page, with a # for each number that a marker looks up: `update_lessons` changes those.
std::string without_values(const std::string& text);

/// The numbers in the sentences of a page that look measured, and that no marker above their
/// paragraph names: those with three digits or more, or with two behind a point. Formulas, code and
/// tables are no sentences.
std::vector<Finding> unmarked_numbers(const std::string& text);

}  // namespace bounce::test
