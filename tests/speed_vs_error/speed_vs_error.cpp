// Speed against error, for every method of every stage and for other programs on the same work.
// usage: speed_vs_error measure     runs everything (minutes), writes the CSV and the figures
//        speed_vs_error figures     draws the figures again from the CSV
//        speed_vs_error NAME [CASE] prints a table of docs/speed_vs_error.md from the CSV

#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>

#include "speed_vs_error/figures.hpp"
#include "speed_vs_error/measure.hpp"
#include "speed_vs_error/tables.hpp"

using namespace bounce::report;

namespace {

const std::string root = BOUNCE_SOURCE_DIR;

std::string read_csv() {
  std::ifstream file(root + "/" + csv_file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

int run(const std::string& what) {
  if (what == "measure") {
    const std::string csv = to_csv(measure());
    std::ofstream(root + "/" + csv_file) << csv;
    draw_figures(from_csv(csv), csv, root);
  } else if (what == "figures") {
    draw_figures(from_csv(read_csv()), read_csv(), root);
  } else {
    std::printf("%s", table(from_csv(read_csv()), what).c_str());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string what;
  for (int i = 1; i < argc; ++i) what += (i > 1 ? " " : "") + std::string(argv[i]);
  try {
    return run(what);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed_vs_error: %s\n", error.what());
    return 1;
  }
}
