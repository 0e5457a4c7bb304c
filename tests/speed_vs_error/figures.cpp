#include "speed_vs_error/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace bounce::report {
namespace {

constexpr double smallest = 1e-16, largest = 10;  // m: what the axis shows

bool is_drawn(const Result& r) { return r.position_error > 0 && r.position_error <= largest; }

/// "exact" is drawn where the axis ends when its error is rounding; a bare loop has no error.
bool is_measured(const Result& r) { return !std::isnan(r.position_error) || r.method == "exact"; }

/// How a curve looks: the same in every figure. The course's methods have colours that are told
/// apart with any colour vision (Okabe and Ito) and filled marks, other programs hollow ones.
struct Look {
  const char* colour;
  int mark;  // gnuplot's number
};

Look look_of(const std::string& method) {
  static const std::map<std::string, Look> looks{{"explicit-euler", {"#d55e00", 9}},
                                                 {"semi-implicit-euler", {"#0072b2", 7}},
                                                 {"velocity-verlet", {"#009e73", 5}},
                                                 {"rk4", {"#cc79a7", 13}},
                                                 {"rk4-events", {"#cc79a7", 12}},
                                                 {"flight-rk4", {"#6a1b74", 11}},
                                                 {"reference", {"#e69f00", 15}},
                                                 {"exact", {"#000000", 1}},
                                                 {"exact in lanes", {"#000000", 6}},
                                                 {"exact with push-only", {"#000000", 2}},
                                                 {"restitution by formula", {"#56b4e9", 6}},
                                                 {"Odeint rk4", {"#999999", 8}},
                                                 {"Odeint dopri5", {"#999999", 4}},
                                                 {"Odeint dopri5 + events", {"#4d4d4d", 10}},
                                                 {"CVODE Adams + events", {"#8c510a", 12}},
                                                 {"Bullet", {"#b8860b", 4}},
                                                 {"Bullet without margins", {"#b8860b", 10}},
                                                 {"ODE", {"#d6336c", 6}},
                                                 {"Box2D", {"#4d4d4d", 14}},
                                                 {"MuJoCo Euler", {"#2a9fd6", 8}},
                                                 {"MuJoCo RK4", {"#2a9fd6", 12}}};
  const auto found = looks.find(method);
  if (found == looks.end()) throw std::runtime_error("no colour is chosen for " + method);
  return found->second;
}

/// At most six curves for a lesson: the course's own, without those that say nothing new there.
std::vector<std::string> methods_to_choose(const Report& report, const std::string& case_name) {
  std::vector<std::string> methods;
  for (const std::string& method : methods_in(report, case_name)) {
    const Result first = results_of(report, case_name, method)[0];
    const bool shown = first.knob == "dt" || method == "exact" || method == "reference";
    if (shown && !first.is_peer && is_measured(first)) methods.push_back(method);
  }
  for (const char* last : {"rk4-events", "reference"}) {
    const auto found = std::find(methods.begin(), methods.end(), last);
    if (methods.size() > 6 && found != methods.end()) methods.erase(found);
  }
  return methods;
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
std::string script(const Report& report, const std::string& case_name,
                   const std::vector<std::string>& methods, const std::string& file) {
  std::ostringstream out;
  out << "set terminal svg size 760," << 420 + 20 * ((methods.size() + 1) / 2)
      << " font 'DejaVu Sans,13' "
      << "background '#ffffff'\nset output '" << file << "'\n"
      << "set logscale xy\nset format xy '10^{%T}'\n"
      << "set xrange [" << left_end(results_in(report, case_name)) << ":" << largest << "]\n"
      << "set xlabel 'largest error of the position [m]' offset 0,0.4\n"
      << "set ylabel 'CPU time per simulated second [us]'\n"
      << "set key below center horizontal maxcols 3\nset grid linecolor '#dddddd'\n";
  std::string plots, points;
  for (const std::string& method : methods) {
    std::vector<Result> results = results_of(report, case_name, method);
    if (method == "exact" && std::isnan(results[0].position_error)) {
      results[0].position_error = 2e-16;  // rounding: where the axis ends
    }
    results.erase(std::remove_if(results.begin(), results.end(),
                                 [](const Result& r) { return !is_drawn(r); }),
                  results.end());
    if (results.empty()) continue;
    const Look look = look_of(method);
    const bool below = method == "explicit-euler";  // in free fall another lies upon it
    plots += std::string(plots.empty() ? "plot" : ",") + " '-' with " +
             (results.size() == 1 ? "points pointsize 1.2 linewidth 2"
                                  : "linespoints pointsize 0.6 linewidth ") +
             (results.size() == 1 ? ""
              : below             ? "5"
                                  : "2") +
             " linecolor rgb '" + look.colour + "' pointtype " + std::to_string(look.mark) +
             (results[0].is_peer ? " dashtype 2" : "") + " title '" + method + "'";
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

std::string choice_file(const std::string& case_name) {
  return "docs/images/choice_" + case_name + ".svg";
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
  const auto draw = [&](const std::string& name, const std::vector<std::string>& methods,
                        const std::string& file) {
    FILE* gnuplot = popen("gnuplot", "w");
    if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
    const std::string commands = script(report, name, methods, file);
    std::fwrite(commands.data(), 1, commands.size(), gnuplot);
    if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot failed (is it installed?)");
    std::ofstream(file, std::ios::app)
        << "<!-- drawn from " << csv_file << " with fingerprint " << fingerprint(csv) << " -->\n";
  };
  std::set<int> stages;
  for (const std::string& name : cases_in(report)) {
    draw(name, methods_in(report, name), root + "/" + figure_file(name));
    if (!stages.insert(results_in(report, name)[0].stage).second) continue;
    draw(name, methods_to_choose(report, name), root + "/" + choice_file(name));
  }
}

}  // namespace bounce::report
