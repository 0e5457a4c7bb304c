#include <doctest/doctest.h>

#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "docs/lesson_tool.hpp"
#include "run_program.hpp"

using namespace bounce;

namespace {

/// Whether a test of that name is there: one of doctest's, or one that CMake adds.
class TestNames {
 public:
  TestNames() {
    for (const std::string program :
         {"physics_tests", "hard_cases_tests", "run_tests", "many_balls_tests"}) {
      listed_ += test::run_program(program + " -ltc").out;
    }
    std::erase(listed_, '\r');  // Windows
    // What needs SDL2, glibc's traps or libFuzzer is in the sources everywhere.
    const std::string tests = std::string(BOUNCE_SOURCE_DIR) + "/tests/";
    for (const std::string file : {"app/playback_test.cpp", "app/racket_game_test.cpp",
                                   "hard_cases/floating_point_traps_test.cpp",
                                   "hard_cases/CMakeLists.txt", "CMakeLists.txt"}) {
      sources_ += test::read_file(tests + file);
    }
  }

  bool has(const std::string& name) const {
    const std::string fuzzer = name.substr(0, name.find(" finds nothing"));
    return listed_.find("\n" + name + "\n") != std::string::npos ||
           sources_.find("\"" + name + "\"") != std::string::npos ||
           (fuzzer != name && sources_.find("\n  fuzz(" + fuzzer + " ") != std::string::npos);
  }

 private:
  std::string listed_, sources_;
};

/// The cells of a row of a table, without the spaces around them.
std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> found;
  for (std::size_t at = 2, end; (end = row.find(" |", at)) != std::string::npos; at = end + 3) {
    found.push_back(row.substr(at, end - at));
  }
  return found;
}

}  // namespace

TEST_CASE("every case of the page of hard cases has a number, and names a test that is there") {
  const TestNames names;
  std::istringstream page(test::read_file(std::string(BOUNCE_SOURCE_DIR) + "/docs/hard_cases.md"));
  int cases = 0, row_of_table = 0;
  for (std::string line; std::getline(page, line);) {
    // lessons_test.cpp compares the column `naively` of such a table with what the program
    // measures.
    if (line.rfind("<!-- cases: naive_numbers ", 0) == 0) row_of_table = 1;
    if (row_of_table == 0) continue;
    if (line.empty()) {
      row_of_table = 0;
    } else if (++row_of_table > 4) {
      ++cases;
      CAPTURE(line);
      const std::vector<std::string> row = cells(line);  // case, naively, here, test
      REQUIRE(row.size() == 4);
      bool has_number = false;
      for (const char letter : row[1]) has_number |= std::isdigit(letter) != 0;
      CHECK(has_number);
      int tests = 0;
      for (std::size_t at = 0, end; (at = row[3].find('`', at)) != std::string::npos;
           at = end + 1) {
        end = row[3].find('`', at + 1);
        const std::string name = row[3].substr(at + 1, end - at - 1);
        INFO("the test '" << name << "'");
        CHECK(names.has(name));
        ++tests;
      }
      CHECK(tests > 0);
    }
  }
  CHECK(cases >= 56);
}
