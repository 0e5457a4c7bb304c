#pragma once
#include <string>
#include <vector>

#include "speed_vs_error/subjects.hpp"

namespace bounce::report {

/// A report: on which machine and when, and what was measured.
struct Report {
  std::vector<std::string> about;  // "name: value"
  std::vector<Result> results;
};

/// The old report with the cases of the fresh one in place of its own.
Report merged(const Report& old, const Report& fresh);

/// The file that the page and the figures are made from.
inline constexpr const char* csv_file = "docs/speed_vs_error.csv";

std::string to_csv(const Report& report);
Report from_csv(const std::string& text);  // throws std::runtime_error

/// A number that changes with every character of the text (FNV-1a): each figure carries the one of
/// the CSV that it was drawn from.
std::string fingerprint(const std::string& text);

/// The names of the methods in one case, in the order of the file.
std::vector<std::string> methods_in(const Report& report, const std::string& case_name);

/// All results of one case.
std::vector<Result> results_in(const Report& report, const std::string& case_name);

/// All results of one method in one case.
std::vector<Result> results_of(const Report& report, const std::string& case_name,
                               const std::string& method);

/// The straight line through log(position error) against log(dt) by least squares, over the steps
/// of at most 1 ms whose errors are neither rounding nor nonsense; not a number for fewer than
/// five.
struct ErrorLine {
  double order;
  double with_1_ms;  // m; not a number if 1 ms is none of these steps
};
ErrorLine error_line(const std::vector<Result>& results);

}  // namespace bounce::report
