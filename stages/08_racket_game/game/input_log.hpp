#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "08_racket_game/game/game.hpp"
#include "physics/text.hpp"
#include "run/input_file.hpp"
#include "run/output_file.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// All inputs of one round, and what else that round needs to come again to the bit.
struct InputLog {
  struct Entry {
    long long step;  // the first step that sees it
    Input input;
  };
  std::vector<Entry> entries = {};
  std::uint64_t seed = 1;
  int round = 0;
  double dt = 1e-3;  // s
  std::string method = "semi-implicit-euler";
  std::vector<std::pair<std::string, std::string>> parameters = {};

  /// Forgets what a run that was taken back had noted from `step` on.
  void note(long long step, const Input& input) {
    while (!entries.empty() && entries.back().step >= step) entries.pop_back();
    entries.push_back({step, input});
  }
};

inline constexpr const char* input_log_first_line = "bounce input, version 1";

/// As readable text, with numbers in decimals that read back to the same bits.
inline void write_input_log(const std::string& path, const InputLog& log) {
  std::string text = std::string(input_log_first_line) + "\n";
  text += "seed " + std::to_string(log.seed) + "\nround " + std::to_string(log.round) + "\n";
  text += "dt " + to_text(log.dt) + "\nmethod " + log.method + "\n";
  for (const auto& [name, value] : log.parameters) text += "set." + name + " " + value + "\n";
  for (const InputLog::Entry& entry : log.entries) {
    text += "input " + std::to_string(entry.step);
    for (const double* number : numbers_of(entry.input)) text += "," + to_text(*number);
    text += "\n";
  }
  text += "end\n";
  OutputFile file("--record-input", path);
  file.write(text);
  file.finish();
}

/// Throws BadInput when the file is none that was recorded, or not all of it.
inline InputLog read_input_log(const std::string& path) {
  InputFile file("--replay", path, "it must be a file that --record-input wrote");
  if (!file.next_line() || file.line() != input_log_first_line) {
    file.refuse("it does not begin as recorded inputs do");
  }
  InputLog log;
  while (file.next_line() && file.line() != "end") {
    const std::string& line = file.line();
    const std::string word = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(line.size(), word.size() + 1));
    if (word == "seed") {
      log.seed = static_cast<std::uint64_t>(file.whole_number(word, rest, {0, 1e15}));
    } else if (word == "round") {
      log.round = static_cast<int>(file.whole_number(word, rest, {0, 1e9}));
    } else if (word == "dt") {
      log.dt = file.number(word, rest, Simulation::valid_dt, "s");
    } else if (word == "method") {
      log.method = rest;
    } else if (word.rfind("set.", 0) == 0) {
      log.parameters.emplace_back(word.substr(4), rest);
    } else if (word == "input") {
      const std::vector<std::string> all = split(rest);
      if (all.size() != 7) file.refuse_line("input: '" + rest + "' must be 7 numbers");
      InputLog::Entry entry{file.whole_number(word, all[0], {0, 1e15}), {}};
      std::size_t i = 1;
      for (double* number : numbers_of(entry.input)) {
        *number = file.number(word, all[i++], Simulation::valid_number);
      }
      log.entries.push_back(entry);
    } else {
      file.refuse_line("it says '" + word.substr(0, 40) + "'");
    }
  }
  if (file.line() != "end") file.refuse("its end is missing");
  return log;
}

}  // namespace bounce
