#include "speed_vs_error/results.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace bounce::report {
namespace {

constexpr const char* header =
    "case,stage,method,peer,knob,value,position_error_m,velocity_error_m_per_s,energy_drift,"
    "top_error,top_time_error_s,cpu_us_per_s,force_evaluations_per_s";

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::string to_csv(const Report& report) {
  std::string text;
  for (const std::string& line : report.about) text += "# " + line + "\n";
  text += std::string(header) + "\n";
  for (const Result& r : report.results) {
    text += r.case_name + "," + std::to_string(r.stage) + "," + r.method + "," +
            (r.is_peer ? "yes" : "no") + "," + r.knob;
    for (const double number : {r.value, r.position_error, r.velocity_error, r.energy_drift,
                                r.top_error, r.top_time_error, r.cost, r.evaluations}) {
      text += "," + rounded(number);
    }
    text += "\n";
  }
  return text;
}

Report from_csv(const std::string& text) {
  Report report;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("# ", 0) == 0) {
      report.about.push_back(line.substr(2));
      continue;
    }
    if (line == header) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() != 13)
      throw std::runtime_error("not a row of " + std::string(csv_file) + ": " + line);
    const auto number = [&cells](std::size_t i) { return std::stod(cells[i]); };
    report.results.push_back({cells[0], std::stoi(cells[1]), cells[2], cells[4], number(5),
                              cells[3] == "yes", number(6), number(7), number(8), number(9),
                              number(10), number(11), number(12)});
  }
  return report;
}

Report merged(const Report& old, const Report& fresh) {
  Report both{fresh.about, {}};
  both.about.push_back("in parts: not all in one run");
  const auto has = [](const Report& report, const std::string& name) {
    return std::any_of(report.results.begin(), report.results.end(),
                       [&name](const Result& r) { return r.case_name == name; });
  };
  std::string placed;  // a fresh case takes the place of the old one
  for (const Result& r : old.results) {
    if (!has(fresh, r.case_name)) {
      both.results.push_back(r);
    } else if (placed.find("," + r.case_name + ",") == std::string::npos) {
      placed += "," + r.case_name + ",";
      for (const Result& f : fresh.results) {
        if (f.case_name == r.case_name) both.results.push_back(f);
      }
    }
  }
  for (const Result& f : fresh.results) {
    if (!has(old, f.case_name)) both.results.push_back(f);
  }
  return both;
}

std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::vector<std::string> methods_in(const Report& report, const std::string& case_name) {
  std::vector<std::string> methods;
  for (const Result& r : report.results) {
    if (r.case_name != case_name) continue;
    if (std::find(methods.begin(), methods.end(), r.method) == methods.end()) {
      methods.push_back(r.method);
    }
  }
  return methods;
}

std::vector<Result> results_in(const Report& report, const std::string& case_name) {
  std::vector<Result> found;
  for (const Result& r : report.results) {
    if (r.case_name == case_name) found.push_back(r);
  }
  return found;
}

std::vector<Result> results_of(const Report& report, const std::string& case_name,
                               const std::string& method) {
  std::vector<Result> found;
  for (const Result& r : results_in(report, case_name)) {
    if (r.method == method) found.push_back(r);
  }
  return found;
}

ErrorLine error_line(const std::vector<Result>& results) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Result best{};  // smaller steps than its only add rounding
  best.position_error = std::numeric_limits<double>::infinity();
  for (const Result& r : results) {
    if (r.position_error < best.position_error) best = r;
  }
  const auto fits = [&best](const Result& r) {
    return r.knob == "dt" && r.value < 1.1e-3 && r.value >= best.value && r.position_error < 0.1 &&
           r.position_error > (best.position_error < 1e-10 ? 1e-10 : 0);
  };
  double n = 0, mx = 0, my = 0, sxy = 0, sxx = 0, largest = 0;
  for (const Result& r : results) {
    if (!fits(r)) continue;
    n += 1, mx += std::log(r.value), my += std::log(r.position_error);
    largest = std::max(largest, r.value);
  }
  if (n < 5) return {none, none};
  for (const Result& r : results) {
    if (!fits(r)) continue;
    const double x = std::log(r.value) - mx / n;
    sxy += x * (std::log(r.position_error) - my / n);
    sxx += x * x;
  }
  const double order = sxy / sxx;
  return {order, largest > 0.9e-3 ? std::exp(my / n + order * (std::log(1e-3) - mx / n)) : none};
}

}  // namespace bounce::report
