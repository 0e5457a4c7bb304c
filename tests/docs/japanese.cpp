#include "docs/japanese.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <map>
#include <regex>
#include <sstream>

#include "docs/lesson_values.hpp"

namespace bounce::test {
namespace {

namespace fs = std::filesystem;
using Counted = std::map<std::string, int>;

/// A page, taken apart.
struct Page {
  std::string prose;  // all but what is made
  std::vector<std::string> levels, markers;
  Counted links, code, formulas, numbers;
};

bool begins(const std::string& line, const char* with) { return line.rfind(with, 0) == 0; }

/// Takes what fits out of the line. What is counted is the first group.
void take(std::string& line, const std::regex& pattern, Counted& counted) {
  for (std::sregex_iterator at(line.begin(), line.end(), pattern), end; at != end; ++at) {
    ++counted[(*at)[1].str()];
  }
  line = std::regex_replace(line, pattern, " ");
}

/// One line of prose: its code, its links, its formulas, and the numbers of what is left.
void read_line(std::string line, Page& page) {
  static const std::regex code("`([^`]+)`"), link("\\]\\(([^)]*)\\)"), formula("\\$+([^$]+)\\$+");
  static const std::regex number("([0-9]+(?:\\.[0-9]+)?(?:e-?[0-9]+)?)");
  take(line, code, page.code);
  take(line, link, page.links);
  take(line, formula, page.formulas);
  take(line, number, page.numbers);
}

Page taken_apart(const std::string& text) {
  Page page;
  std::istringstream lines(text);
  bool marked = false;  // the line before is a marker of what is made
  for (std::string line; std::getline(lines, line);) {
    // The site gives a Japanese page the live figures of its English one.
    if (begins(line, "<!-- english: ") || begins(line, "<!-- live: ")) continue;
    const bool made = marked;
    if (!made) page.prose += line + "\n";
    marked = begins(line, "<!-- ") && !begins(line, "<!-- by hand") && !begins(line, "<!-- value");
    if (begins(line, "<!-- ")) page.markers.push_back(line);
    if (begins(line, "#")) page.levels.push_back(line.substr(0, line.find(' ')));
    if (begins(line, "```")) {
      const bool told = line == "```text" && !made;  // a plan, for example
      if (!told && !made) ++page.code[line];
      while (std::getline(lines, line) && line != "```") {
        if (!made) page.prose += line + "\n";
        if (told) read_line(line, page);
        if (!told && !made) ++page.code[line];
      }
    } else if (made) {
      while (!line.empty() && std::getline(lines, line)) continue;
    } else if (!begins(line, "<")) {
      read_line(line, page);
    }
  }
  return page;
}

/// What a word of a number may be in Japanese: "ten times" is 10倍. (A million is 100万, a billion
/// 10億.)
const std::map<std::string, std::string>& number_words() {
  static const std::map<std::string, std::string> words{
      {"a", "1"},          {"an", "1"},       {"one", "1"},        {"first", "1"},
      {"once", "1"},       {"each", "1"},     {"every", "1"},      {"two", "2"},
      {"second", "2"},     {"twice", "2"},    {"both", "2"},       {"half", "2"},
      {"again", "2"},      {"three", "3"},    {"third", "3"},      {"four", "4"},
      {"fourth", "4"},     {"quarter", "4"},  {"five", "5"},       {"six", "6"},
      {"sixth", "6"},      {"seven", "7"},    {"eight", "8"},      {"nine", "9"},
      {"ninth", "9"},      {"ten", "10"},     {"tenth", "10"},     {"fifteen", "15"},
      {"twentieth", "20"}, {"fifty", "50"},   {"fiftieth", "50"},  {"hundred", "100"},
      {"million", "100"},  {"billion", "10"}, {"thousand", "1000"}};
  return words;
}

/// How often a number may come in Japanese, beyond the English digits.
Counted words_for_numbers(const std::string& prose) {
  Counted found;
  std::string word;
  for (const char c : prose + " ") {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else {
      if (const auto at = number_words().find(word); at != number_words().end())
        ++found[at->second];
      word.clear();
    }
  }
  return found;
}

/// Where links lead, counted from the root. What has a Japanese page leads there; a page's own
/// twin, and what there is in Japanese only, do not count.
Counted places(const fs::path& root, const fs::path& page, const fs::path& twin,
               const Counted& links) {
  Counted found;
  for (const auto& [target, count] : links) {
    if (target.find("://") != std::string::npos) {
      found[target] += count;
      continue;
    }
    const std::size_t hash = std::min(target.find('#'), target.size());
    fs::path file = (page.parent_path() / target.substr(0, hash)).lexically_normal();
    const fs::path japanese = "docs/ja" / file.filename();
    if (file.parent_path() == "docs" && fs::exists(root / japanese)) file = japanese;
    const bool only_japanese =
        file.parent_path() == "docs/ja" && !fs::exists(root / "docs" / file.filename());
    if (only_japanese || file == page || file == twin) continue;
    // A heading is another one in Japanese.
    found[file.generic_string() + (file == japanese ? "" : target.substr(hash))] += count;
  }
  return found;
}

void compare(const char* what, const Counted& english, const Counted& japanese,
             std::vector<std::string>& said) {
  Counted all = english;
  for (const auto& one : japanese) all.emplace(one.first, 0);
  const auto count = [](const Counted& in, const std::string& key) {
    const auto at = in.find(key);
    return at == in.end() ? 0 : at->second;
  };
  for (const auto& one : all) {
    const int here = count(english, one.first), there = count(japanese, one.first);
    if (here == there) continue;
    said.push_back(std::string(what) + " '" + one.first + "': " + std::to_string(here) +
                   " times in English, " + std::to_string(there) + " times in Japanese");
  }
}

void compare(const char* what, const std::vector<std::string>& english,
             const std::vector<std::string>& japanese, std::vector<std::string>& said) {
  for (std::size_t i = 0; i < std::max(english.size(), japanese.size()); ++i) {
    const std::string here = i < english.size() ? english[i] : "none";
    const std::string there = i < japanese.size() ? japanese[i] : "none";
    if (here == there) continue;
    said.push_back(std::string(what) + " number " + std::to_string(i + 1) + " is " + here +
                   " in English, and in Japanese " + there);
    return;
  }
}

}  // namespace

std::vector<fs::path> japanese_pages(const fs::path& root) {
  std::vector<fs::path> pages;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs/ja")) {
    const fs::path name = entry.path().filename();
    if (name.extension() == ".md" && fs::exists(root / english_of(name)))
      pages.push_back("docs/ja" / name);
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

fs::path english_of(const fs::path& japanese) {
  return japanese.filename() == "start.md" ? "README.md" : "docs" / japanese.filename();
}

std::string stamp_of(const std::string& english) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : taken_apart(without_values(english)).prose) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  char text[40];
  std::snprintf(text, sizeof text, "<!-- english: %016llx -->",
                static_cast<unsigned long long>(hash));
  return text;
}

std::vector<std::string> differences(const fs::path& root, const fs::path& japanese,
                                     const std::string& english_text,
                                     const std::string& japanese_text) {
  const fs::path english = english_of(japanese);
  const Page here = taken_apart(english_text), there = taken_apart(japanese_text);
  std::vector<std::string> said;
  compare("heading", here.levels, there.levels, said);
  compare("marker", here.markers, there.markers, said);
  compare("a link to", places(root, english, japanese, here.links),
          places(root, japanese, english, there.links), said);
  compare("the code", here.code, there.code, said);
  compare("the formula", here.formulas, there.formulas, said);
  // A number in digits is one in both. A number in words may be in digits in Japanese.
  const Counted words = words_for_numbers(here.prose);
  Counted numbers = here.numbers;
  for (const auto& [number, count] : there.numbers) {
    const auto word = words.find(number);
    const int more = count - numbers[number];
    if (word != words.end()) numbers[number] += std::clamp(more, 0, word->second);
  }
  compare("the number", numbers, there.numbers, said);
  return said;
}

}  // namespace bounce::test
