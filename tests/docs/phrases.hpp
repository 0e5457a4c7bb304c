#pragma once
#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "run_program.hpp"

namespace bounce::test {

/// What is made in English and read in Japanese: a file of pairs, an English line, the Japanese one
/// below it, and an empty line. {1}, {2} stand for whatever is there, such as a number. A line that
/// begins with # is a comment.
class Phrases {
 public:
  using Pair = std::pair<std::string, std::string>;

  explicit Phrases(const std::string& path) {
    std::istringstream file(read_file(path));
    std::string english;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      if (!line.empty() && line.back() == '\r') line.pop_back();  // of Windows
      if (!line.empty() && line[0] == '#') continue;
      if (line.empty() != english.empty() && line.empty()) {
        throw std::runtime_error(path + ":" + std::to_string(number) +
                                 ": without Japanese: " + english);
      }
      if (line.empty()) continue;
      if (!english.empty()) pairs_.emplace_back(english, line);
      english = english.empty() ? line : "";
    }
  }

  const std::vector<Pair>& pairs() const { return pairs_; }

  /// The Japanese of a text; nothing where there is none.
  std::optional<std::string> japanese(const std::string& text) const {
    for (const auto& [english, japanese] : pairs_) {
      if (const auto given = match(text, english)) {
        std::string said = japanese;
        for (std::size_t i = 0; i < given->size(); ++i) {
          const std::string name = "{" + std::to_string(i + 1) + "}";
          said.replace(said.find(name), name.size(), (*given)[i]);
        }
        return said;
      }
    }
    return {};
  }

 private:
  /// What stands for {1}, {2}, ... when the text is like the pattern. They come in this order.
  static std::optional<std::vector<std::string>> match(std::string text,
                                                       const std::string& pattern) {
    std::vector<std::string> given;
    std::size_t at = pattern.find('{');
    if (text.compare(0, at, pattern, 0, at) != 0) return {};
    if (at == std::string::npos) {
      if (text != pattern) return {};
      return given;
    }
    text.erase(0, at);
    while (at != std::string::npos) {
      const std::size_t from = pattern.find('}', at) + 1, next = pattern.find('{', from);
      const std::string then = pattern.substr(from, next - from);
      const bool last = next == std::string::npos;
      if (last && text.size() < then.size()) return {};
      const std::size_t end = last ? text.size() - then.size() : text.find(then);
      if (end == std::string::npos || text.compare(end, then.size(), then) != 0) return {};
      given.push_back(text.substr(0, end));
      text.erase(0, end + then.size());
      at = next;
    }
    return given;
  }

  std::vector<Pair> pairs_;
};

}  // namespace bounce::test
