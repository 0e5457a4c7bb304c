#pragma once
#include "speed_vs_error/results.hpp"

namespace bounce::report {

/// Runs the cases with these names, or all when there are none. Takes minutes, and says on standard
/// error how far it is. Throws std::runtime_error when there is no such case.
Report measure(const std::vector<std::string>& wanted);

}  // namespace bounce::report
