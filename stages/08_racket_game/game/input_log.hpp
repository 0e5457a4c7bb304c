#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "08_racket_game/game/game.hpp"
#include "physics/text.hpp"
#include "run/output_file.hpp"

namespace bounce {

/// All inputs of one round, and what else that round needs to come again to the bit.
struct InputLog {
  struct Entry {
    long long step;  // the first step that sees it
    Input input;
  };
  std::vector<Entry> entries;
  std::uint64_t seed = 1;
  int round = 0;
  double dt = 1e-3;  // s
  std::string method = "semi-implicit-euler";
  std::vector<std::pair<std::string, std::string>> parameters;

  /// Forgets what a run that was taken back had noted from `step` on.
  void note(long long step, const Input& input) {
    while (!entries.empty() && entries.back().step >= step) entries.pop_back();
    entries.push_back({step, input});
  }
};

inline constexpr const char* input_log_first_line = "bounce input, version 1";

inline std::array<double, 6> numbers_of(const Input& input) {
  return {input.x, input.z, input.tilt_x, input.tilt_z, input.swing, input.assist};
}

/// As readable text, with numbers in decimals that read back to the same bits.
inline void write_input_log(const std::string& path, const InputLog& log) {
  std::string text = std::string(input_log_first_line) + "\n";
  text += "seed " + std::to_string(log.seed) + "\nround " + std::to_string(log.round) + "\n";
  text += "dt " + to_text(log.dt) + "\nmethod " + log.method + "\n";
  for (const auto& [name, value] : log.parameters) text += "set." + name + " " + value + "\n";
  for (const InputLog::Entry& entry : log.entries) {
    text += "input " + std::to_string(entry.step) + "," + to_text(numbers_of(entry.input)) + "\n";
  }
  text += "end\n";
  OutputFile file("--record-input", path);
  file.write(text);
  file.finish();
}

/// Throws BadInput when the file is none that was recorded, or not all of it.
inline InputLog read_input_log(const std::string& path) {
  const auto refuse = [&path](const std::string& why) {
    throw BadInput("--replay '" + path + "' is not allowed: " + why +
                   "; it must be a file that --record-input wrote");
  };
  std::ifstream file(path);
  if (!file) refuse("it must be a file that can be read");
  std::string line;
  if (!std::getline(file, line) || line != input_log_first_line) {
    refuse("it does not begin as recorded inputs do");
  }
  const auto number = [&](const std::string& text) {
    const std::optional<double> value = parse_number(text);
    if (!value) {
      refuse("in the line of '" + line.substr(0, line.find(' ')) + "', '" + text.substr(0, 40) +
             "' is no number");
    }
    return *value;
  };
  InputLog log;
  while (std::getline(file, line) && line != "end") {
    const std::string word = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(line.size(), word.size() + 1));
    if (word == "seed") {
      log.seed = static_cast<std::uint64_t>(std::clamp(number(rest), 0.0, 1e15));
    } else if (word == "round") {
      log.round = static_cast<int>(std::clamp(number(rest), 0.0, 1e9));
    } else if (word == "dt") {
      log.dt = number(rest);
      if (!(log.dt >= 1e-15 && log.dt <= 1e15))
        refuse("its dt is " + rest + ", and may be from 1e-15 to 1e15 (s)");
    } else if (word == "method") {
      log.method = rest;
    } else if (word.rfind("set.", 0) == 0) {
      log.parameters.emplace_back(word.substr(4), rest);
    } else if (word == "input") {
      std::vector<double> all;
      for (const std::string& text : split(rest)) all.push_back(number(text));
      if (all.size() != 7 || all[0] < 0 || all[0] > 1e15) {
        refuse("an input has 7 numbers, the first from 0 to 1e15, and not '" + rest + "'");
      }
      log.entries.push_back(
          {static_cast<long long>(all[0]), {all[1], all[2], all[3], all[4], all[5], all[6]}});
    } else {
      refuse("it says '" + word.substr(0, 40) + "'");
    }
  }
  if (line != "end") refuse("its end is missing");
  return log;
}

}  // namespace bounce
