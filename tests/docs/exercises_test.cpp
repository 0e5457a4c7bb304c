#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace fs = std::filesystem;
using bounce::test::read_file;

namespace {

const fs::path project_root = BOUNCE_SOURCE_DIR;

/// The stages that have an exercise.
std::vector<fs::path> exercises() {
  std::vector<fs::path> all;
  for (const auto& stage : fs::directory_iterator(project_root / "stages")) {
    if (fs::exists(stage.path() / "gaps.hpp")) all.push_back(stage.path());
  }
  return all;
}

/// The stage's own header, as its subject under check names it.
std::string course_header(const std::string& stage) {
  fs::path subject = project_root / "stages" / stage / "tests/subject.cpp";  // ./course new made it
  if (!fs::exists(subject)) subject = project_root / "tests/checks/subjects" / (stage + ".cpp");
  const std::string text = read_file(subject.string());
  const std::string before = "#define BOUNCE_STAGE_HEADER \"";
  const std::size_t at = text.find(before) + before.size();
  return read_file((project_root / "stages" / text.substr(at, text.find('"', at) - at)).string());
}

using Lines = std::vector<std::string>;

/// The lines between each two `// [name]` lines.
std::map<std::string, Lines> parts_of(const std::string& text) {
  std::map<std::string, Lines> parts;
  std::string inside;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = std::min(line.find_first_not_of(' '), line.size());
    const bool is_mark = line.compare(at, 4, "// [") == 0 && line.back() == ']';
    const std::string name = is_mark ? line.substr(at + 4, line.size() - at - 5) : "";
    if (is_mark && inside.empty()) {
      REQUIRE_MESSAGE(parts.count(name) == 0, "two parts are called ", name);
      parts[inside = name] = {};
    } else if (is_mark) {
      REQUIRE_MESSAGE(inside == name, "the part ", inside, " ends with the mark ", name);
      inside.clear();
    } else if (!inside.empty()) {
      parts[inside].push_back(line);
    }
  }
  REQUIRE_MESSAGE(inside.empty(), "the part ", inside, " has no end");
  return parts;
}

bool has(const Lines& lines, const std::string& text) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(text) != line.npos; });
}

}  // namespace

TEST_CASE("a gap takes the place of a part of its stage's file, asks for it, and is no answer") {
  REQUIRE(exercises().size() >= 8);
  for (const fs::path& stage : exercises()) {
    CAPTURE(stage.string());
    const auto taught = parts_of(course_header(stage.filename().string()));
    const auto gaps = parts_of(read_file((stage / "gaps.hpp").string()));
    CHECK(!gaps.empty());
    for (const auto& part : gaps) {
      const auto& [name, gap] = part;
      CAPTURE(part.first);
      REQUIRE(taught.count(name) == 1);
      CHECK(has(gap, "YOUR TURN"));
      CHECK(has(gap, "Must hold: "));
      CHECK(has(gap, "// <- here"));
      const Lines& answer = taught.at(name);
      CHECK_FALSE(has(answer, "YOUR TURN"));
      CHECK(std::any_of(answer.begin(), answer.end(),
                        [&gap = gap](const std::string& line) { return !has(gap, line); }));
    }
  }
}

TEST_CASE("the gaps of a stage are counted: YOUR TURN 2 of 3") {
  for (const fs::path& stage : exercises()) {
    CAPTURE(stage.string());
    const std::string text = read_file((stage / "gaps.hpp").string());
    const std::size_t count = parts_of(text).size();
    std::size_t at = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      const std::string which = std::to_string(i) + " of " + std::to_string(count);
      at = text.find("YOUR TURN" + (count == 1 ? "" : " " + which) + ": ", at);
      REQUIRE_MESSAGE(at != std::string::npos, "not there, or not in this order: ", which);
    }
  }
}

/// What the first three lines of an exercise must say, and that there are three hints.
static void check_head_and_hints(const fs::path& file, const fs::path& hints_file,
                                 const std::string& lesson) {
  CAPTURE(file.string());
  const std::string gaps = read_file(file.string());
  const std::string head = gaps.substr(0, gaps.find("\n\n"));
  CHECK(std::count(head.begin(), head.end(), '\n') == 2);
  CHECK((has({head}, "mine.hpp") || has({head}, "mine_method.hpp")));
  CHECK(has({head}, "./course check"));
  CHECK(has({head}, lesson));
  const std::string hints = read_file(hints_file.string());
  int hints_found = 1;
  for (std::size_t at = hints.find("\n---\n"); at != std::string::npos;
       at = hints.find("\n---\n", at + 1)) {
    ++hints_found;
  }
  CHECK(hints_found == 3);
}

TEST_CASE("an exercise says in its first three lines what to do, and has three hints") {
  for (const fs::path& stage : exercises()) {
    check_head_and_hints(stage / "gaps.hpp", stage / "hints.txt",
                         "docs/" + stage.filename().string() + ".md");
  }
  const fs::path loop = project_root / "stages/02_spring_floor/own_method";
  check_head_and_hints(loop / "my_method.hpp", loop / "hints.txt",
                       "docs/deeper/02_spring_floor.md");
}

TEST_CASE("the exercise of a better loop asks for one thing, and is no answer") {
  const auto parts = parts_of(course_header("loop"));
  REQUIRE(parts.size() == 1);
  const Lines& gap = parts.at("step");
  for (const char* text : {"YOUR TURN: ", "Must hold: ", "// <- here"}) CHECK(has(gap, text));
  CHECK_FALSE(has(gap, "state.velocity +="));
}
