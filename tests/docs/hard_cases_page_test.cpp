#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "docs/lesson_tool.hpp"
#include "run_program.hpp"

using namespace bounce;

TEST_CASE("every case of the page of hard cases names a test that is there") {
  std::string names;
  for (const std::string program : {"physics_tests", "hard_cases_tests", "run_tests"}) {
    names += test::run_program(program + " -ltc").out;
  }
  // The window's tests are there where SDL2 is.
  const std::string folder = std::string(BOUNCE_SOURCE_DIR) + "/tests/app/";
  const std::string of_window = test::read_file(folder + "player_test.cpp") +
                                test::read_file(folder + "racket_game_test.cpp");
  std::istringstream page(test::read_file(std::string(BOUNCE_SOURCE_DIR) + "/docs/hard_cases.md"));
  int cases = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| ", 0) != 0 || line.size() < 5 || line.substr(line.size() - 3) != "` |") {
      continue;
    }
    const std::size_t end = line.size() - 3, begin = line.rfind('`', end - 1) + 1;
    const std::string name = line.substr(begin, end - begin);
    CAPTURE(line);
    const bool is_there = names.find("\n" + name + "\n") != std::string::npos ||
                          of_window.find("\"" + name + "\"") != std::string::npos;
    CHECK(is_there);
    ++cases;
  }
  CHECK(cases >= 40);
}
