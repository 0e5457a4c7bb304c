#pragma once
#include <string>

#include "speed_vs_error/results.hpp"

namespace bounce::report {

/// The name of a case's figure: docs/images/speed_vs_error_CASE.svg.
std::string figure_file(const std::string& case_name);
/// And of the one with at most six curves, for the second page of a lesson: choice_CASE.svg.
std::string choice_file(const std::string& case_name);

/// The names of all cases in the report, in its order.
std::vector<std::string> cases_in(const Report& report);

/// Draws one log-log figure a case with gnuplot: error across, CPU time per simulated second up,
/// one curve a method; and for the first case of each stage the one for its page. `root` is the top
/// of the project. Throws std::runtime_error where gnuplot fails.
void draw_figures(const Report& report, const std::string& csv, const std::string& root);

}  // namespace bounce::report
