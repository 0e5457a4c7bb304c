#pragma once
#include "speed_vs_error/results.hpp"

namespace bounce::report {

/// Runs everything. Takes minutes, and says on standard error how far it is.
Report measure();

}  // namespace bounce::report
