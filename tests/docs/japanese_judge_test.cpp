// What ./course check says in Japanese: tests/checks/japanese.txt has each English sentence of the
// judge and of the script, and nothing that they no longer say.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "docs/phrases.hpp"

using namespace bounce::test;
namespace fs = std::filesystem;

namespace {

const fs::path judge_root = BOUNCE_SOURCE_DIR;
const std::vector<Phrases::Pair>& table() {
  static const Phrases phrases((judge_root / "tests/checks/japanese.txt").string());
  return phrases.pairs();
}

/// A text that is written in the code; adjacent ones are one.
struct Literal {
  std::string file, text;
};

std::vector<Literal> literals_of(const fs::path& file) {
  std::vector<Literal> all;
  std::string text;
  std::istringstream lines(read_file(file.string()));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("#include", 0) == 0) continue;
    const std::size_t comment = std::min(line.find("// "), line.size());
    const bool inside =
        std::count(line.begin(), line.begin() + static_cast<long>(comment), '"') % 2 != 0;
    text += (inside ? line : line.substr(0, comment)) + "\n";
  }
  bool adjacent = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.compare(at, 3, "'\"'") == 0) {  // no text begins here
      at += 2;
      adjacent = false;
    } else if (text[at] == '"') {
      std::string words;
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
        words += text[at - 1] == '\\' && text[at] == 'n' ? '\n' : text[at];
      }
      if (adjacent) {
        all.back().text += words;
      } else {
        all.push_back({file.filename().string(), words});
      }
      adjacent = true;
    } else if (!std::isspace(static_cast<unsigned char>(text[at]))) {
      adjacent = false;
    }
  }
  return all;
}

/// What a shell or awk script prints: the formats behind its printf, back and die.
std::vector<Literal> formats_of(const fs::path& file, const std::string& from,
                                const std::string& to) {
  std::vector<Literal> all;
  std::string text = read_file(file.string());
  if (!from.empty()) text.erase(0, text.find(from));
  if (!to.empty()) text.erase(text.find(to));
  text = std::regex_replace(text, std::regex("\\$\\([^()]*\\)|\\$\\{[^}]*\\}"),
                            "%s");  // these have quotes of their own
  const std::regex format("(?:printf|back\\(|die|say) *(?:'([^']*)'|\"((?:[^\"\\\\]|\\\\.)*)\")");
  for (std::sregex_iterator at(text.begin(), text.end(), format), end; at != end; ++at) {
    all.push_back({file.filename().string(), (*at)[1].str() + (*at)[2].str()});
  }
  return all;
}

// These say nothing to a learner.
const std::set<std::string> not_for_learners{"main.cpp", "judge.cpp", "subject.hpp",
                                             "shared_page.hpp"};
const std::set<std::string> not_said{
    "all checks ran",           "the right answer", "no check at all",
    "should fail in",           "but failed in",    "no pipe, no memory, or no temporary file",
    "no process for your code", "#pragma once //"};

std::vector<Literal> said_to_learners() {
  std::vector<Literal> all;
  const auto take = [&all](const std::vector<Literal>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const auto& entry : fs::directory_iterator(judge_root / "tests/checks")) {
    const fs::path extension = entry.path().extension();
    const std::string name = entry.path().filename().string();
    if ((extension == ".cpp" || extension == ".hpp") && not_for_learners.count(name) == 0)
      take(literals_of(entry.path()));
  }
  take(literals_of(judge_root / "stages/new/check.cpp"));
  take(literals_of(judge_root / "tests/checks/plan.awk"));
  take(formats_of(judge_root / "tests/checks/compiler_said.sh", "", ""));
  take(formats_of(judge_root / "course", "# ---- What the machine", ""));
  std::istringstream course(read_file((judge_root / "course").string()));
  bool usage = false;
  for (std::string line; std::getline(course, line);) {
    if (usage && line != "TEXT") all.push_back({"course", line});
    usage = line.find("cat <<'TEXT'") != std::string::npos || (usage && line != "TEXT");
  }
  return all;
}

/// Cut at the %s of a format, the {1} of a pattern, and the like; what has two words or more.
std::vector<std::string> pieces_of(const std::string& text, bool short_ones = false) {
  static const std::regex hole(
      "%[-0-9.]*l?[a-z]|\\{[0-9][.;=]*\\}|\\$\\([^)]*\\)|\\$\\{[^}]*\\}|\\$[a-z0-9]+|\\\\n|\n|\" "
      "[a-z0-9. \\[\\]\"+-]* \"");
  static const std::regex two_words("[A-Za-z]{2,}[,;:.]? +[A-Za-z]{2,}");
  std::vector<std::string> pieces;
  for (std::sregex_token_iterator at(text.begin(), text.end(), hole, -1), end; at != end; ++at) {
    std::string piece = std::regex_replace(at->str(), std::regex("\\\\(.)"), "$1");
    piece.erase(0, piece.find_first_not_of(' '));
    piece.erase(piece.find_last_not_of(' ') + 1);
    while (!piece.empty() && (piece.back() == ':' || piece.back() == ' ')) piece.pop_back();
    const bool counts = short_ones ? piece.size() > 2 : std::regex_search(piece, two_words);
    if (counts) pieces.push_back(piece);
  }
  return pieces;
}

/// Names of parameters and units only: "; mass ", " m/s, radius ". They are the same in Japanese.
bool is_names_only(const std::string& text) {
  static const std::set<std::string> names{"mass",
                                           "gravity",
                                           "radius",
                                           "stiffness",
                                           "damping",
                                           "contact",
                                           "push_only",
                                           "position",
                                           "velocity",
                                           "normal",
                                           "offset",
                                           "amplitude",
                                           "phase",
                                           "floor_velocity",
                                           "angular_frequency",
                                           "floor_law",
                                           "absolute",
                                           "fixed_switch",
                                           "kg",
                                           "m",
                                           "s",
                                           "y",
                                           "v",
                                           "t",
                                           "dt",
                                           "may"};
  std::string word;
  for (const char c : text + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') {
      word += c;
    } else if (!word.empty()) {
      if (names.count(word) == 0) return false;
      word.clear();
    }
  }
  return true;
}

std::set<std::string> holes_of(const std::string& text) {
  static const std::regex hole("\\{([0-9])[.;=]*\\}");
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), hole), end; at != end; ++at)
    found.insert((*at)[1].str());
  return found;
}

/// How many columns of a terminal a text takes: a letter that is not ASCII takes two.
int columns(const std::string& text) {
  int count = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) count += 1;
    if (byte >= 0xc0) count += 2;
  }
  return count;
}

}  // namespace

TEST_CASE("each sentence of the judge has its Japanese, with the same numbers in it") {
  CHECK(table().size() > 400);
  std::set<std::string> seen;
  for (const Phrases::Pair& pair : table()) {
    const std::string &english = pair.first, &japanese = pair.second;
    CAPTURE(english);
    CHECK(holes_of(english) == holes_of(japanese));
    CHECK_MESSAGE(seen.insert(english).second, "this sentence is there twice");
    const bool translated = std::any_of(japanese.begin(), japanese.end(), [](char c) {
      return static_cast<unsigned char>(c) >= 0x80;
    });
    CHECK((translated || english.rfind("docs/", 0) == 0));
  }
}

/// A piece of a sentence is part of a row; or a piece of a row is part of it, and the rest are
/// names.
static bool has_row(const std::string& piece) {
  static const std::vector<std::string> pieces = [] {
    std::vector<std::string> all;
    for (const auto& pair : table()) {
      if (pair.first.find('{') == std::string::npos) continue;
      for (const std::string& row : pieces_of(pair.first)) all.push_back(row);
    }
    return all;
  }();
  const auto is_row = [](const std::string& text) {
    return std::any_of(table().begin(), table().end(),
                       [&](const auto& one) { return one.first == text; });
  };
  for (const auto& pair : table()) {
    if (pair.first.find(piece) != std::string::npos) return true;
  }
  return std::any_of(pieces.begin(), pieces.end(), [&](const std::string& row) {
    const std::size_t at = piece.find(row);
    if (at == std::string::npos) return false;
    const std::string before = piece.substr(0, at), after = piece.substr(at + row.size());
    return (is_names_only(before) || is_row(before)) && is_names_only(after);
  });
}

TEST_CASE("what the judge and the script say is in the table") {
  int found = 0;
  for (const Literal& one : said_to_learners()) {
    for (const std::string& piece : pieces_of(one.text)) {
      const bool is_lesson = piece.rfind("docs/", 0) == 0,
                 is_json = piece.find("\": ") != std::string::npos;
      if (is_names_only(piece) || is_lesson || is_json || not_said.count(piece) > 0) continue;
      ++found;
      CHECK_MESSAGE(has_row(piece), one.file, " says '", piece,
                    "'. tests/checks/japanese.txt needs it, and its Japanese");
    }
  }
  CHECK(found > 300);
}

TEST_CASE("the table has nothing that nobody says") {
  std::vector<std::string> said;
  for (const Literal& one : said_to_learners()) {
    for (const std::string& piece : pieces_of(one.text, true)) said.push_back(piece);
  }
  std::sort(said.begin(), said.end(),
            [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (const auto& pair : table()) {
    std::string rest = pair.first;  // what is left when all that is said somewhere is taken out
    for (const std::string& row : pieces_of(rest)) {
      const bool whole = std::any_of(said.begin(), said.end(), [&](const std::string& one) {
        return one.find(row) != std::string::npos;
      });
      if (whole) rest.replace(rest.find(row), row.size(), "{");
    }
    for (const std::string& piece : said) {
      const std::size_t at = rest.find(piece);
      if (at != std::string::npos) rest.replace(at, piece.size(), "{");
    }
    CHECK_MESSAGE(pieces_of(rest).empty(), "nobody says '", pair.first, "': ", rest);
  }
}

TEST_CASE("the labels of a verdict are as wide as each other, in full-width letters too") {
  int labels = 0;
  for (const Phrases::Pair& pair : table()) {
    const std::string &english = pair.first, &japanese = pair.second;
    const std::size_t hole = japanese.find('{');
    if (english.rfind("    ", 0) == 0 && english.find("  {1") == 14 - 2) {
      CHECK_MESSAGE(columns(japanese.substr(0, hole)) == 16, japanese);
      ++labels;
    }
    if (english.rfind("  ok ", 0) == 0 || english.rfind("  not yet ", 0) == 0)
      CHECK_MESSAGE(columns(japanese.substr(0, hole)) == 11, japanese);
    // The head of the table of speeds: its columns end where the numbers do.
    if (english.rfind("    dt [s] ", 0) == 0) CHECK_MESSAGE(columns(japanese) == 68, japanese);
  }
  CHECK(labels >= 8);
}
