// Measures speed against error, for every method of every stage and for other programs on the same
// work (minutes), writes docs/speed_vs_error.csv and draws the figures.
// usage: measure_speed           runs everything
//        measure_speed CASE...   measures these anew, and keeps the rest of the CSV

#include <cstdio>
#include <exception>
#include <fstream>

#include "run_program.hpp"
#include "speed_vs_error/figures.hpp"
#include "speed_vs_error/measure.hpp"

using namespace bounce::report;

namespace {

void run(const std::vector<std::string>& cases) {
  const std::string root = BOUNCE_SOURCE_DIR, path = root + "/" + csv_file;
  const Report fresh = measure(cases);
  const std::string csv =
      to_csv(cases.empty() ? fresh : merged(from_csv(bounce::test::read_file(path)), fresh));
  std::ofstream(path) << csv;
  draw_figures(from_csv(csv), csv, root);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure_speed: %s\n", error.what());
    return 1;
  }
}
