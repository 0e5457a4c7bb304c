// Speed against error: the tables and figures of what was measured (measure_speed.cpp).
// usage: speed_vs_error figures         draws the figures from docs/speed_vs_error.csv
//        speed_vs_error NAME [CASE]     prints a table of docs/speed_vs_error.md from it

#include <cstdio>
#include <exception>

#include "run_program.hpp"
#include "speed_vs_error/figures.hpp"
#include "speed_vs_error/tables.hpp"

using namespace bounce::report;

namespace {

void run(const std::vector<std::string>& words) {
  const std::string root = BOUNCE_SOURCE_DIR, csv = bounce::test::read_file(root + "/" + csv_file);
  if (words == std::vector<std::string>{"figures"}) return draw_figures(from_csv(csv), csv, root);
  std::string name;
  for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
  std::printf("%s", table(from_csv(csv), name).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed_vs_error: %s\n", error.what());
    return 1;
  }
}
