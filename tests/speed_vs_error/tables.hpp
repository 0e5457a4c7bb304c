#pragma once
#include <string>

#include "speed_vs_error/results.hpp"

namespace bounce::report {

/// A markdown table made from the report: "machine", "headline", "orders", "events", "model",
/// "plane", "engines", "choice CASE" or "cost CASE". Throws std::runtime_error for any other name.
std::string table(const Report& report, const std::string& name);

}  // namespace bounce::report
