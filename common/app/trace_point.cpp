#include "app/trace_point.hpp"

#include <algorithm>
#include <limits>

namespace bounce {
namespace {

double value_in(const std::vector<double>& values, std::string_view columns,
                std::string_view name) {
  const std::vector<std::string> names = split(columns);
  const auto found = std::find(names.begin(), names.end(), name);
  const auto at = static_cast<std::size_t>(found - names.begin());
  return found != names.end() && at < values.size() ? values[at]
                                                    : std::numeric_limits<double>::quiet_NaN();
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
