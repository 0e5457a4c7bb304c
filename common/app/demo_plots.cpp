// The quantities that demos plot.
#include "app/demo.hpp"
#include "app/palette.hpp"

namespace bounce {

Plot plot_column(const std::string& title, const std::string& unit, const std::string& column) {
  return {title, unit, palette::motion,
          [column](const TracePoint& point) { return point.column(column); },
          [column](const TracePoint& point) { return point.exact_column(column); }};
}

Plot plot_error(const std::string& title, const std::string& unit, const std::string& column) {
  return {title, unit, palette::ink, [column](const TracePoint& point) {
            return point.column(column) - point.exact_column(column);
          }};
}

Plot plot_kinetic_energy(const std::string& title) {
  return {title, "J", palette::motion,
          [](const TracePoint& point) { return point.energy.kinetic; }};
}

Plot plot_spring_energy(const std::string& title) {
  return {title, "J", palette::spring, [](const TracePoint& point) { return point.energy.spring; }};
}

Plot plot_lost_energy(const std::string& title) {
  return {title, "J", palette::damper, [](const TracePoint& point) { return point.lost; }};
}

Plot plot_energy_error(const std::string& title) {
  return {title, "J", palette::ink, [](const TracePoint& point) { return point.energy_error(); }};
}

}  // namespace bounce
