#pragma once
#include <optional>
#include <string>
#include <vector>

#include "run/options.hpp"

namespace bounce {

/// The words of the command line as they came; checked later, so that all messages are ours.
struct Words {
  std::optional<std::string> method, dt, duration, tolerance, sample, at, seed;
  std::vector<std::string> set;
  bool list = false;
};

/// Splits the command line into words, and puts paths and flags into `options`. Returns false when
/// the question was `--help`, and is answered. Throws BadInput for what is no option.
bool read_words(int argc, const char* const* argv, const StageName& stage,
                const std::vector<StageOption>& of_stage, Words& words, Options& options);

/// Answers a question on standard output. Throws MachineFailure.
void answer(const std::string& option, const std::string& text);

}  // namespace bounce
