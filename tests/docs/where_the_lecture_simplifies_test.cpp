// The page that says where the lecture simplifies quotes a line of code in each of its rows.
#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "run_program.hpp"

using bounce::test::read_file;

TEST_CASE("each place where the lecture simplifies names a line of code that is there") {
  const std::string root = BOUNCE_SOURCE_DIR;
  std::istringstream page(read_file(root + "/docs/where_the_slides_simplify.md"));
  int rows = -2;  // the two lines of the table's head
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("|", 0) != 0 || ++rows < 1) continue;
    CAPTURE(line);
    // | ... | [`code`](../file) | ... |
    const std::string begin = "| [`", middle = "`](../";
    const std::size_t code = line.find(begin), file = line.find(middle);
    REQUIRE(code != std::string::npos);
    REQUIRE(file != std::string::npos);
    const std::size_t code_at = code + begin.size(), file_at = file + middle.size();
    const std::string quoted = line.substr(code_at, file - code_at);
    const std::string text =
        read_file(root + "/" + line.substr(file_at, line.find(')', file_at) - file_at));
    CHECK_MESSAGE(text.find(quoted) != std::string::npos, "no longer in the file: ", quoted);
  }
  CHECK(rows >= 15);
}
