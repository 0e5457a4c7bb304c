// docs/mistakes.md tells which changes of a learner's lines no check minds
// (tests/mistakes/mutate.py finds them). Lines move on; here it is seen that the page does not
// quote one that is gone.
#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <sstream>
#include <string>

#include "run_program.hpp"

using bounce::test::read_file;

namespace {

/// A change is one of operators, comparisons, signs and numbers: the letters stay.
std::string letters_of(const std::string& line) {
  std::string letters;
  for (const char c : line.substr(0, line.find("//"))) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') letters += c;
  }
  return letters;
}

std::string header_of(char stage) {
  for (const auto& folder : std::filesystem::directory_iterator(BOUNCE_SOURCE_DIR "/stages")) {
    const std::string name = folder.path().filename().string();
    if (name[1] != stage) continue;
    return read_file((folder.path() / (name.substr(3) + ".hpp")).string());
  }
  return "";
}

}  // namespace

TEST_CASE("the lines that mistakes.md quotes are there, but for one change") {
  std::istringstream page(read_file(BOUNCE_SOURCE_DIR "/docs/mistakes.md"));
  bool changes = false;
  int found = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| stage | the changed line |", 0) == 0) changes = true;
    if (!changes || line.rfind("|---", 0) == 0 || line.find('`') == std::string::npos) continue;
    const std::size_t begin = line.find('`') + 1;
    const std::string changed = line.substr(begin, line.find('`', begin) - begin);
    std::istringstream header(header_of(line[2]));
    bool there = false;
    for (std::string code; std::getline(header, code);) {
      there |= letters_of(code) == letters_of(changed);
    }
    CHECK_MESSAGE(there, "stage ", line.substr(2, 1), " has no line like ", changed,
                  ": tests/mistakes/mutate.py --write mends the page");
    ++found;
  }
  CHECK(found > 0);
}
