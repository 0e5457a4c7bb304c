#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace fs = std::filesystem;
using bounce::test::read_file;

namespace {

const fs::path root = BOUNCE_SOURCE_DIR;

std::vector<fs::path> exercises() {
  std::vector<fs::path> all;
  for (const auto& stage : fs::directory_iterator(root / "stages")) {
    if (fs::exists(stage.path() / "exercise.hpp")) all.push_back(stage.path() / "exercise.hpp");
  }
  return all;
}

/// The stage's own header, as its subject under check names it.
std::string course_header(const std::string& stage) {
  const std::string text = read_file((root / "tests/checks/subjects" / (stage + ".cpp")).string());
  const std::string before = "#define BOUNCE_STAGE_HEADER \"";
  const std::size_t at = text.find(before) + before.size();
  return read_file((root / "stages" / text.substr(at, text.find('"', at) - at)).string());
}

/// The text without what stands between two `// [name]` lines of the exercise.
std::string without_gaps(const std::string& text, const std::string& exercise) {
  std::istringstream lines(text);
  std::string kept;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("// [");
    const bool is_mark = at != std::string::npos && line.back() == ']' &&
                         line.find_first_not_of(' ') == at &&
                         exercise.find(line + "\n") != std::string::npos &&
                         exercise.find("YOUR TURN") != std::string::npos;
    if (is_mark) inside = !inside;
    if (!inside && !is_mark) kept += line + "\n";
  }
  return kept;
}

}  // namespace

TEST_CASE("an exercise is its stage's file with the taught lines left out, and nothing else") {
  REQUIRE(exercises().size() >= 3);
  for (const fs::path& path : exercises()) {
    const std::string stage = path.parent_path().filename().string();
    INFO(path.string(), " and the stage's own header differ outside the gaps");
    std::string exercise = read_file(path.string());
    exercise.erase(0, exercise.find("#pragma once"));
    CHECK(without_gaps(exercise, exercise) == without_gaps(course_header(stage), exercise));
  }
}

TEST_CASE("an exercise says in its first three lines what to do, and has three hints") {
  for (const fs::path& path : exercises()) {
    CAPTURE(path.string());
    std::ifstream file(path);
    std::string head, line;
    for (int i = 0; i < 3 && std::getline(file, line); ++i) head += line + "\n";
    CHECK(head.find("mine.hpp") != std::string::npos);
    CHECK(head.find("./course check") != std::string::npos);
    CHECK(head.find("docs/" + path.parent_path().filename().string() + ".md") != std::string::npos);
    const std::string hints = read_file((path.parent_path() / "hints.txt").string());
    int hints_found = 1;
    for (std::size_t at = hints.find("\n---\n"); at != std::string::npos;
         at = hints.find("\n---\n", at + 1)) {
      ++hints_found;
    }
    CHECK(hints_found == 3);
  }
}
