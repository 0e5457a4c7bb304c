// The numbers of a lesson's "How wrong, how fast?" are quoted from its second page, where a program
// makes them. When they change there, the lesson has to follow.
#include <doctest/doctest.h>

#include <array>
#include <regex>
#include <string>

#include "run_program.hpp"

using bounce::test::read_file;

// A number is quoted in the unit of its page, so that it can be found there.
static const std::array lessons{
    "01_free_fall.md",        "02_spring_floor.md",   "03_damping.md",
    "04_three_dimensions.md", "05_ball_collision.md", "06_oscillating_floor.md",
    "07_tilted_plane.md",     "08_racket_game.md",
};

TEST_CASE("the numbers that a lesson quotes stand on its second page") {
  const std::string docs = std::string(BOUNCE_SOURCE_DIR) + "/docs/";
  int found = 0;
  for (const std::string name : lessons) {
    const std::string page = read_file(docs + "deeper/" + name);
    const std::string lesson = read_file(docs + name);
    const std::size_t begin = lesson.find("\n## How wrong, how fast?\n");
    REQUIRE_MESSAGE(begin != std::string::npos, name, " has no such section");
    const std::string section =
        std::regex_replace(lesson.substr(begin + 1, lesson.find("\n## ", begin + 1) - begin),
                           std::regex("<!--.*-->"), "");
    // Only those with a decimal point: "3 lines" needs no source.
    const std::regex decimal("[0-9]+\\.[0-9]+");
    for (std::sregex_iterator at(section.begin(), section.end(), decimal), end; at != end; ++at) {
      const std::string number = at->str();
      CHECK_MESSAGE(page.find(number) != std::string::npos, "docs/", name, " quotes ", number,
                    ", which docs/deeper/", name, " does not have");
      ++found;
    }
  }
  CHECK(found >= 10);
}
