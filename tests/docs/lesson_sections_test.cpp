// A check that fails and a gap to be filled send the learner to a section of a lesson, by its
// heading. Sections move; here it is seen that nobody is sent to one that is no longer there.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "run_program.hpp"

using bounce::test::read_file;
namespace fs = std::filesystem;

namespace {

bool has_section(const std::string& page, const std::string& heading) {
  const std::string text = read_file(std::string(BOUNCE_SOURCE_DIR) + "/" + page);
  return text.find("# " + heading + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("the sections that the checks name are there") {
  int found = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(BOUNCE_SOURCE_DIR) / "tests/checks")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = read_file(entry.path().string());
    // In the code a lesson is named as "docs/NN_name.md, \"Heading\"".
    const std::string middle = ".md, \\\"", end = "\\\"";
    for (std::size_t at = text.find(middle); at != std::string::npos; at = text.find(middle, at)) {
      const std::size_t page = text.rfind("docs/", at);
      REQUIRE(page != std::string::npos);
      const std::string name = text.substr(page, at + 3 - page);
      at += middle.size();
      const std::string heading = text.substr(at, text.find(end, at) - at);
      CHECK_MESSAGE(has_section(name, heading), entry.path().filename().string(), " names ", name,
                    ", '", heading, "'");
      ++found;
    }
  }
  CHECK(found >= 15);
}

TEST_CASE("the sections that the gaps name are there") {
  int found = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(BOUNCE_SOURCE_DIR) / "stages")) {
    const std::string stage = entry.path().filename().string();
    const std::string text = read_file((entry.path() / "gaps.hpp").string());
    const std::string begin = "(Lesson: \"";
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
      at += begin.size();
      const std::string heading = text.substr(at, text.find('"', at) - at);
      CHECK_MESSAGE(has_section("docs/" + stage + ".md", heading), "the gaps of ", stage, " name '",
                    heading, "'");
      ++found;
    }
  }
  CHECK(found >= 10);
}
