#pragma once
#include <string>
#include <vector>

#include "checks/diagnosis.hpp"

namespace bounce::check {

using Indices = std::vector<std::size_t>;

/// Of which parts the answers to the questions `where` are made, in words: the parts of the right
/// answer, and at most two more. Nothing unless that gives *all* of these answers.
std::string composition(const Evidence& evidence, const Indices& where);

/// The largest component, without sign.
double size_of(const Triple& triple);
/// "a, b and c"
std::string listed(const std::vector<std::string>& words);

}  // namespace bounce::check
