// Measures the stability map, and draws it: docs/stability_map.csv, docs/restitution_range.csv and
// docs/images/stability_map.svg (gnuplot). With a word, prints a table for docs/hard_cases.md.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hard_cases/stability_measured.hpp"
#include "physics/text.hpp"
#include "speed_vs_error/results.hpp"

using namespace bounce;
using namespace bounce::hard_cases;

namespace {

const std::vector<Method> all_methods = AnyMethod<SteppingMethods<double>>::offered();
const Method bouncing[] = {methods::semi_implicit_euler, methods::velocity_verlet, methods::rk4};

std::string digits(double value, int count) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}

std::string limits(const std::vector<double>& zetas) {
  std::string csv = "method,zeta,theory,measured\n";
  for (const Method method : all_methods) {
    for (const double zeta : zetas) {
      // Without a damper explicit Euler is never stable: there is nothing to bisect.
      if (method == methods::explicit_euler && zeta == 0) continue;
      csv += name_of(method) + "," + to_text(zeta) + "," +
             digits(method.largest_stable_step(1, zeta), 6) + "," +
             digits(measured_limit(method, zeta), 6) + "\n";
    }
  }
  return csv;
}

std::string ranges(const std::vector<double>& steps, int phases) {
  std::string csv = "method,omega0 dt,lowest restitution,highest restitution\n";
  for (const Method method : bouncing) {
    for (const double step : steps) {
      const RestitutionRange range = restitution_range(method, {0}, step, phases);
      csv += name_of(method) + "," + to_text(step) + "," + digits(range.lowest, 4) + "," +
             digits(range.highest, 4) + "\n";
    }
  }
  return csv;
}

/// The same as a table of a lesson.
std::string as_table(const std::string& csv) {
  std::string table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const auto words = split(line);
    table += "| " + join(words, " | ") + " |\n";
    if (words[0] != "method") continue;
    for (std::size_t i = 0; i < words.size(); ++i) table += "|---";
    table += "|\n";
  }
  return table;
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv, const std::string& method) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (const auto words = split(line); words[0] == method) rows.push_back(words);
  }
  return rows;
}

/// Columns `x` and `y` of a method's rows, as gnuplot wants them inline.
std::string points(const std::string& csv, Method method, std::size_t x, std::size_t y) {
  std::string text;
  for (const auto& row : rows_of(csv, name_of(method))) text += row[x] + " " + row[y] + "\n";
  return text + "e\n";
}

std::string script(const std::string& limit_csv, const std::string& range_csv,
                   const std::string& file) {
  std::ostringstream out;
  out << "set terminal svg size 1080,500 font 'DejaVu Sans,17' background '#ffffff'\n"
      << "set linetype 1 linecolor rgb '#d55e00'\nset linetype 2 linecolor rgb '#0072b2'\n"
      << "set linetype 3 linecolor rgb '#009e73'\nset linetype 4 linecolor rgb '#cc79a7'\n"
      << "set output '" << file << "'\nset multiplot layout 1,2\nset grid linecolor '#dddddd'\n"
      << "set title 'stable below the line, and growing above it'\n"
      << "set xlabel 'damping ratio'\nset ylabel 'omega0 dt'\nset xrange [0:3]\nset yrange "
         "[0:3.2]\n"
      << "set key top right\n";
  std::string plots, data;
  int colour = 0;
  for (const Method method : all_methods) {
    ++colour;
    const std::string type = " linetype " + std::to_string(colour);
    const bool below = method == methods::semi_implicit_euler;  // velocity Verlet's lies upon it
    plots += std::string(plots.empty() ? "plot" : ",") + " '-' with lines linewidth " +
             (below ? "6" : "2") + type + " title '" + name_of(method) +
             "', '-' with points pointtype 7 pointsize " +
             (method == methods::velocity_verlet ? "0.3" : "0.5") + type + " notitle";
    data += points(limit_csv, method, 1, 2) + points(limit_csv, method, 1, 3);
  }
  out << plots << "\n" << data;
  out << "set title 'stable, and wrong: a bounce that should return 1'\n"
      << "set xlabel 'omega0 dt'\nset ylabel 'restitution, lowest and highest over the phase'\n"
      << "set xrange [0:2]\nset yrange [0:2.8]\nset key top left\n";
  plots = data = "";
  for (const Method method : {methods::semi_implicit_euler, methods::rk4}) {
    const std::string type = method == methods::rk4 ? " linetype 4" : " linetype 2";
    plots += std::string(plots.empty() ? "plot" : ",") + " '-' with lines linewidth 2" + type +
             " title '" + name_of(method) + "', '-' with lines linewidth 2" + type + " notitle";
    data += points(range_csv, method, 1, 2) + points(range_csv, method, 1, 3);
  }
  out << plots << ", 1 with lines linecolor '#777777' dashtype 2 notitle\n" << data;
  return out.str();
}

void draw(const std::string& commands) {
  FILE* gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
  std::fwrite(commands.data(), 1, commands.size(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (is it installed?)");
}

std::vector<double> evenly(double from, double to, double by) {
  std::vector<double> all;
  for (int i = 0; from + i * by < to + by / 2; ++i)
    all.push_back(std::round((from + i * by) * 1e6) / 1e6);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word == "limits") {
    std::cout << as_table(limits({0, 0.1, 0.5, 1, 2.31}));
    return 0;
  }
  if (word == "ranges") {
    std::cout << as_table(ranges({0.1, 0.5, 1, 1.5, 1.9}, 2000));
    return 0;
  }
  if (!word.empty()) {
    std::cerr << "usage: stability_map [limits|ranges]\n";
    return 2;
  }
  const std::string root = std::string(BOUNCE_SOURCE_DIR) + "/docs/";
  const std::string limit_csv = limits(evenly(0, 3, 0.05));
  const std::string range_csv = ranges(evenly(0.01, 1.95, 0.01), 400);
  std::ofstream(root + "stability_map.csv") << limit_csv;
  std::ofstream(root + "restitution_range.csv") << range_csv;
  const std::string figure = root + "images/stability_map.svg";
  draw(script(limit_csv, range_csv, figure));
  std::ofstream(figure, std::ios::app)
      << "<!-- drawn from docs/stability_map.csv and docs/restitution_range.csv with fingerprint "
      << report::fingerprint(limit_csv + range_csv) << " -->\n";
}
