#include "app/trace_point.hpp"

#include <algorithm>
#include <limits>

namespace bounce {
namespace {

double value_in(const std::vector<double>& values, std::string_view columns,
                std::string_view name) {
  // Plots ask for a thousand points in a frame, so no words are made of the names.
  for (const double value : values) {
    const std::size_t end = std::min(columns.find(','), columns.size());
    if (columns.substr(0, end) == name) return value;
    if (end == columns.size()) break;
    columns.remove_prefix(end + 1);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double TracePoint::column(std::string_view name) const { return value_in(values, columns, name); }
double TracePoint::exact_column(std::string_view name) const {
  return value_in(exact, columns, name);
}

TracePoint trace_point(const Simulation& simulation) {
  const EnergyAccount account = simulation.energy_account();
  return {simulation.traits().columns,
          simulation.time(),
          simulation.values(),
          simulation.exact_values(simulation.time()),
          simulation.energy(),
          account.before,
          account.lost};
}

}  // namespace bounce
