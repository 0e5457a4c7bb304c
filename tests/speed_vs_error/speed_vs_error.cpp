// Speed against error, for every method of every stage and for other programs on the same work.
// usage: speed_vs_error measure         runs everything (minutes), writes the CSV and the figures
//        speed_vs_error measure CASE... measures these anew, and keeps the rest of the CSV
//        speed_vs_error figures         draws the figures again from the CSV
//        speed_vs_error NAME [CASE]     prints a table of docs/speed_vs_error.md from the CSV

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

int run(const std::vector<std::string>& words) {
  const std::string what = words.empty() ? "" : words[0];
  if (what == "measure") {
    const std::vector<std::string> parts(words.begin() + 1, words.end());
    const Report fresh = measure(parts);
    const std::string csv = to_csv(parts.empty() ? fresh : merged(from_csv(read_csv()), fresh));
    std::ofstream(root + "/" + csv_file) << csv;
    draw_figures(from_csv(csv), csv, root);
  } else if (what == "figures") {
    draw_figures(from_csv(read_csv()), read_csv(), root);
  } else {
    std::string name;
    for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
    std::printf("%s", table(from_csv(read_csv()), name).c_str());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed_vs_error: %s\n", error.what());
    return 1;
  }
}
