#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <vector>

#include "docs/lesson_tool.hpp"
#include "speed_vs_error/results.hpp"

using namespace bounce;

// The tables of docs/speed_vs_error.md are made from the CSV by `speed_vs_error`, like every table
// of a lesson: lessons_test.cpp compares them. Here are its figures.
TEST_CASE("the figures of the speed report are drawn from the committed CSV") {
  const std::string root = std::string(BOUNCE_SOURCE_DIR) + "/";
  const std::string csv = test::read_file(root + report::csv_file);
  const report::Report data = report::from_csv(csv);
  std::set<std::string> cases;
  for (const report::Result& result : data.results) cases.insert(result.case_name);
  CHECK(cases.size() >= 6);
  for (const std::string& name : cases) {
    const std::string file = "docs/images/speed_vs_error_" + name + ".svg";
    INFO(file, ": draw it again with build/release/bin/speed_vs_error figures");
    CHECK(test::read_file(root + file).find(report::fingerprint(csv)) != std::string::npos);
    CHECK(test::read_file(root + "docs/speed_vs_error.md").find("images/speed_vs_error_" + name) !=
          std::string::npos);
  }
}

TEST_CASE(
    "what a table says of a method at 1 ms is that of all its steps: a lucky one counts little") {
  std::vector<report::Result> results;
  for (int i = 0; i <= 17; ++i) {
    report::Result r{};
    r.knob = "dt";
    r.value = 1e-3 * std::pow(10, -i / 6.0);
    r.position_error = 3 * r.value * r.value * (i % 2 == 0 ? 1.25 : 0.8);
    results.push_back(r);
  }
  CHECK(report::error_line(results).order == doctest::Approx(2).epsilon(0.02));
  CHECK(report::error_line(results).with_1_ms == doctest::Approx(3e-6).epsilon(0.05));
  results[0].position_error /= 10;
  CHECK(report::error_line(results).with_1_ms == doctest::Approx(3e-6).epsilon(0.4));
  results.erase(results.begin());
  CHECK(std::isnan(report::error_line(results).with_1_ms));  // 1 ms was not run
  CHECK(report::error_line(results).order == doctest::Approx(2).epsilon(0.02));
}

TEST_CASE("every second page shows the figure of its stage, and what to choose from it") {
  const std::string root = std::string(BOUNCE_SOURCE_DIR) + "/";
  const std::string csv = test::read_file(root + report::csv_file);
  const report::Report data = report::from_csv(csv);
  int pages = 0;
  for (const std::filesystem::path& file : test::lesson_files(root)) {
    if (file.parent_path() != "docs/deeper") continue;
    ++pages;
    const std::string name = file.filename().string();
    const std::string text = test::read_file(root + file.string());
    bool figure = false, choice = false;
    for (const report::Result& result : data.results) {
      if (result.stage != name[1] - '0') continue;
      const std::string& of = result.case_name;
      const std::string drawn = root + "docs/images/choice_" + of + ".svg";
      if (std::filesystem::exists(drawn)) {
        CHECK(test::read_file(drawn).find(report::fingerprint(csv)) != std::string::npos);
      }
      figure |= text.find("](../images/choice_" + of + ".svg)") != std::string::npos;
      choice |= text.find("<!-- table: speed_vs_error choice " + of + " -->") != std::string::npos;
    }
    INFO(name);
    CHECK(figure);
    CHECK(choice);
  }
  CHECK(pages >= 4);
  const std::string front = test::read_file(root + "README.md");
  CHECK(front.find("<!-- table: speed_vs_error headline -->") != std::string::npos);
}

TEST_CASE("the CSV of the speed report reads back as it was written") {
  const std::string csv = test::read_file(std::string(BOUNCE_SOURCE_DIR) + "/" + report::csv_file);
  CHECK(report::to_csv(report::from_csv(csv)) == csv);
}

TEST_CASE("the figure of many balls is drawn from the committed CSV") {
  const std::string root = std::string(BOUNCE_SOURCE_DIR) + "/";
  const std::string csv = test::read_file(root + "docs/many_balls.csv");
  INFO("draw it again with build/release/bin/many_balls_speed figure");
  CHECK(test::read_file(root + "docs/images/many_balls.svg").find(report::fingerprint(csv)) !=
        std::string::npos);
}
