// The programs on one page print what the stages' programs print, to the bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "trace.hpp"

using namespace bounce::test;

namespace {

void check_same_rows(const Trace& plain, const Trace& stage) {
  CHECK(plain.header == stage.header);
  REQUIRE(plain.rows.size() == stage.rows.size());
  CHECK(plain.rows.front().front() == 0);
  CHECK(plain.rows.back().front() == 10);
  const auto [differs, other] =
      std::mismatch(plain.rows.begin(), plain.rows.end(), stage.rows.begin());
  if (differs == plain.rows.end()) return;
  for (std::size_t i = 0; i < std::min(differs->size(), other->size()); ++i) {
    CAPTURE(i);
    CHECK((*differs)[i] == (*other)[i]);
  }
  FAIL("the first row that differs is number ", differs - plain.rows.begin());
}

}  // namespace

TEST_CASE("a plain program and its stage's program print the same rows, to the bit") {
  struct Case {
    std::string stage, settings;
    std::size_t balls = 1;
  };
  for (const Case& one :
       {Case{"01_free_fall", ""}, Case{"02_spring_floor", ""}, Case{"03_damping", ""},
        Case{"04_three_dimensions", ""}, Case{"05_ball_collision", "--set scene=tower", 2},
        Case{"06_oscillating_floor", ""}, Case{"07_tilted_plane", ""}}) {
    CAPTURE(one.stage);
    const Trace plain = trace_of(one.stage + "_plain");
    CHECK(plain.rows.size() == 10001 * one.balls);
    check_same_rows(plain, trace_of(one.stage + same_method + one.settings));
  }
}

TEST_CASE("stage 4's plain program prints the same with variables and with vectors") {
  const Trace variables = trace_of("04_three_dimensions_plain");
  check_same_rows(trace_of("04_three_dimensions_plain vectors"), variables);
  // Are there two programs in it?
  const std::string page = text_of_page("04_three_dimensions");
  CHECK(page.find("with_variables();") != std::string::npos);
  CHECK(page.find("with_vectors();") != std::string::npos);
}

TEST_CASE("a plain program is one short page, and includes nothing of the project") {
  const std::vector<std::string> allowed{"#include <iostream>", "#include <cmath>",
                                         "#include <Eigen/Core>"};
  int pages = 0;
  for (const auto& folder : std::filesystem::directory_iterator(BOUNCE_SOURCE_DIR "/stages")) {
    if (!std::filesystem::exists(folder.path() / "main.cpp")) continue;
    const std::string stage = folder.path().filename().string();
    CAPTURE(stage);
    ++pages;
    int count = 0;
    std::istringstream lines(text_of_page(stage));
    for (std::string line; std::getline(lines, line); ++count) {
      CAPTURE(line);
      CHECK(line.size() <= 100);
      if (line.find('#') == std::string::npos) continue;
      CHECK(std::find(allowed.begin(), allowed.end(), line) != allowed.end());
    }
    CHECK(count >= 15);
    CHECK(count <= 70);
  }
  CHECK(pages >= 8);
}
