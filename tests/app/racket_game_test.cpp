#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "run_program.hpp"

using namespace bounce;
namespace fs = std::filesystem;

TEST_CASE("the racket game draws itself, whoever plays") {
  const fs::path picture = fs::temp_directory_path() / "bounce_racket_game.png";
  for (const char* player :
       {"autopilot", "blind", "blind --set strike=speeding", "idle", "human --calm",
        "none --set racket_normal=0.2,-1,0", "none --set position=0,-1,0 --set velocity=0,6,0"}) {
    fs::remove(picture);
    const test::Outcome outcome =
        test::run_program(std::string("08_racket_game --player ") + player +
                          " --duration 3 --screenshot '" + picture.string() + "'");
    CAPTURE(player);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    REQUIRE(fs::exists(picture));
    CHECK(fs::file_size(picture) > 10000);  // more than an empty page
  }
  fs::remove(picture);
}
