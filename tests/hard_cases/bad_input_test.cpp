// Bad input, read as the programs read it. hostile_command_lines table runs the programs
// themselves.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "floating_point_traps.hpp"
#include "hostile_lines.hpp"

using namespace bounce;
using namespace bounce::test;
namespace fs = std::filesystem;

namespace {

/// A folder as the lines expect it (they name ../in/FILE), and we are in it.
struct InFolder {
  ChildFolder folder;
  fs::path before = fs::current_path();
  InFolder() {
    fs::create_directories(folder.path() + "/work");
    fs::create_directories(folder.path() + "/in");
    fs::current_path(folder.path() + "/work");
  }
  ~InFolder() { fs::current_path(before); }
};

/// What the program would say before the run begins; empty: it would begin.
std::string refusal(const Stage& stage, const Line& line) {
  for (const auto& [name, content] : line.files) {
    std::ofstream("../in/" + name, std::ios::binary) << content;
  }
  std::vector<const char*> argv{stage.name.name.c_str()};
  for (const std::string& word : line.words) argv.push_back(word.c_str());
  std::unique_ptr<Simulation> simulation = stage.make();
  Options options;
  try {
    parse_command_line(static_cast<int>(argv.size()), argv.data(), stage.name, simulation, options,
                       stage.options);
  } catch (const BadInput& error) {
    return std::string(error.what()) + "\n";
  }
  return "";
}

const Stage& stage_of(const Line& line) {
  for (const Stage& stage : all_stages()) {
    if (stage.name.name == line.program) return stage;
  }
  FAIL("no stage is called " << line.program);
  return all_stages().front();
}

/// Returns how many were refused.
int check_all(const std::vector<Line>& lines) {
  const WithoutTraps while_absurd_numbers_are_tried;
  const InFolder here;
  int refused = 0;
  for (const Line& line : lines) {
    const std::string sentence = refusal(stage_of(line), line);
    if (sentence.empty()) continue;
    ++refused;
    CAPTURE(line.text());
    CAPTURE(sentence);
    CHECK(complaint_about_sentence(line, sentence) == "");
  }
  return refused;
}

}  // namespace

TEST_CASE("bad input: every parameter and option takes a value, or says field, value and range") {
  for (const Stage& stage : all_stages()) {
    const std::vector<Line> lines = lines_about(known_of(stage));
    CAPTURE(stage.name.name);
    CHECK(lines.size() > 200);
    CHECK(check_all(lines) > 100);  // and not everything was taken
  }
}

TEST_CASE("bad input: every entry of the files is taken, or refused with its name") {
  std::vector<Known> all;
  for (const Stage& stage : all_stages()) all.push_back(known_of(stage));
  const std::vector<Line> lines = lines_about_files(all);
  CHECK(lines.size() > 2000);
  CHECK(check_all(lines) > 1000);
}
