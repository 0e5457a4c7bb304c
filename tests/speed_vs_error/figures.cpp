#include "speed_vs_error/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace bounce::report {
namespace {

constexpr double smallest = 1e-16, largest = 10;  // m: what the axis shows

bool is_drawn(const Result& r) { return r.position_error > 0 && r.position_error <= largest; }

/// How a curve looks: the same in every figure. Colours that are told apart with any colour vision
/// (Okabe and Ito), and a mark for each of the course's methods.
struct Look {
  const char* colour;
  int mark;  // gnuplot's number
};

const std::map<std::string, Look>& looks_of_methods() {
  static const std::map<std::string, Look> looks{
      {"explicit-euler", {"#d55e00", 9}},  {"semi-implicit-euler", {"#0072b2", 7}},
      {"velocity-verlet", {"#009e73", 5}}, {"rk4", {"#b05a8a", 13}},
      {"rk4-events", {"#b05a8a", 12}},     {"flight-rk4", {"#6a1b74", 11}},
      {"reference", {"#e69f00", 15}},      {"exact", {"#000000", 1}}};
  return looks;
}

/// What is no method of the course takes the next of these.
Look look_of_other(std::size_t number) {
  static const Look others[] = {{"#56b4e9", 6},  {"#999999", 8},  {"#c0a000", 4}, {"#555555", 10},
                                {"#d55e00", 14}, {"#000000", 12}, {"#009e73", 6}};
  return others[number % std::size(others)];
}

/// The left end of the axis: rounding where there is `exact`, else near the smallest error.
double left_end(const std::vector<Result>& results) {
  double least = largest;
  for (const Result& r : results) {
    if (r.method == "exact") return smallest;
    if (is_drawn(r)) least = std::min(least, r.position_error);
  }
  return std::pow(10, std::floor(std::log10(least)));
}

/// One gnuplot script: settings, then a curve a method with its points inline.
std::string script(const Report& report, const std::string& case_name, const std::string& file) {
  std::ostringstream out;
  out << "set terminal svg size 760,520 font 'DejaVu Sans,13' background '#ffffff'\n"
      << "set output '" << file << "'\n"
      << "set logscale xy\nset format xy '10^{%T}'\n"
      << "set xrange [" << left_end(results_in(report, case_name)) << ":" << largest << "]\n"
      << "set xlabel 'largest error of the position [m]'\n"
      << "set ylabel 'CPU time per simulated second [us]'\n"
      << "set key outside right top width -6\nset grid linecolor '#dddddd'\n";
  std::string plots, points;
  std::size_t others = 0;
  for (const std::string& method : methods_in(report, case_name)) {
    std::vector<Result> results = results_of(report, case_name, method);
    if (method == "exact" && std::isnan(results[0].position_error)) {
      results[0].position_error = 2e-16;  // rounding: where the axis ends
    }
    results.erase(std::remove_if(results.begin(), results.end(),
                                 [](const Result& r) { return !is_drawn(r); }),
                  results.end());
    if (results.empty()) continue;
    const auto own = looks_of_methods().find(method);
    const Look look = own != looks_of_methods().end() ? own->second : look_of_other(others++);
    plots += std::string(plots.empty() ? "plot" : ",") + " '-' with linespoints linewidth 2 " +
             "linecolor rgb '" + look.colour + "' pointtype " + std::to_string(look.mark) +
             (results[0].is_peer ? " dashtype 2" : "") +
             (results.size() == 1 ? " pointsize 1.2" : " pointsize 0.5") + " title '" + method +
             "'";
    for (const Result& r : results) {
      char point[64];
      std::snprintf(point, sizeof point, "%.4g %.4g\n", r.position_error, r.cost);
      points += point;
    }
    points += "e\n";
  }
  out << plots << "\n" << points;
  return out.str();
}

}  // namespace

std::string figure_file(const std::string& case_name) {
  return "docs/images/speed_vs_error_" + case_name + ".svg";
}

std::vector<std::string> cases_in(const Report& report) {
  std::vector<std::string> names;
  for (const Result& r : report.results) {
    if (std::find(names.begin(), names.end(), r.case_name) == names.end()) {
      names.push_back(r.case_name);
    }
  }
  return names;
}

void draw_figures(const Report& report, const std::string& csv, const std::string& root) {
  for (const std::string& name : cases_in(report)) {
    const std::string file = root + "/" + figure_file(name);
    FILE* gnuplot = popen("gnuplot", "w");
    if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
    const std::string commands = script(report, name, file);
    std::fwrite(commands.data(), 1, commands.size(), gnuplot);
    if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (is it installed?)");
    std::ofstream(file, std::ios::app)
        << "<!-- drawn from " << csv_file << " with fingerprint " << fingerprint(csv) << " -->\n";
  }
}

}  // namespace bounce::report
