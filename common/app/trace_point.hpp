#pragma once
#include <string_view>
#include <vector>

#include "run/simulation.hpp"

namespace bounce {

/// One moment of a run, as the pictures and plots need it.
struct TracePoint {
  std::string_view columns;    // names of the values
  double t;                    // s
  std::vector<double> values;  // as in the CSV trace, without t; empty in old points of many balls
  std::vector<double> exact;   // the exact solution's; empty where there is none
  Energy energy;               // J
  double before;               // energy at the start of the book [J]
  double lost;                 // taken by the damper since then [J]
  /// Neither here nor taken: the method's error [J].
  double energy_error() const { return energy.total() + lost - before; }

  /// The value in that column, of the first ball where there are many; NaN where there is none.
  double column(std::string_view name) const;
  double exact_column(std::string_view name) const;
};

constexpr double trace_interval = 1.0 / 240;  // s between two of them, unless a step is longer

/// Where a simulation stands now.
TracePoint trace_point(const Simulation& simulation);

}  // namespace bounce
