#pragma once
#include <algorithm>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"

namespace bounce {

/// One dot of the picture: a bounce, at one value of the parameter that is swept.
struct SweepRow {
  double parameter, phase, height;
};

/// One diagram: `value` of every row against the parameter, a pixel each.
inline void draw_diagram(Canvas& canvas, const Diagram& diagram, const std::vector<SweepRow>& rows,
                         double SweepRow::*value, const std::string& title) {
  diagram.draw(canvas, title, 10, 5, "", true);
  std::set<std::pair<int, int>> drawn;  // many bounces, few places: one dot for each
  for (const SweepRow& row : rows) {
    const Point dot = diagram.at(row.parameter, row.*value);
    const std::pair<int, int> pixel(static_cast<int>(dot.x), static_cast<int>(dot.y));
    if (!drawn.insert(pixel).second) continue;
    const auto x = static_cast<float>(pixel.first), y = static_cast<float>(pixel.second);
    draw_rect(canvas, {x, y, 1.5f, 1.5f}, palette::motion.faded(0.6));
  }
}

/// Where bounces settle, against the parameter: their height, and the floor's angle at the impact.
inline void draw_bifurcation(Canvas& canvas, const std::vector<SweepRow>& rows, Range across,
                             const std::string& name, const std::string& unit) {
  double highest = 0;
  for (const SweepRow& row : rows) highest = std::max(highest, row.height);
  const std::vector<double> round = ticks(0, highest, 5);
  const double top = round.size() > 1 ? round.back() + round[1] : 1;
  const float width = layout::width - 120;
  const Diagram heights{{80, 60, width, 370}, across, {0, top}};
  const Diagram phases{{80, 494, width, 160}, across, {0, 2 * std::numbers::pi}};
  draw_diagram(canvas, heights, rows, &SweepRow::height, "height of the bounce, m");
  draw_diagram(canvas, phases, rows, &SweepRow::phase,
               "angle of the floor's swing at the impact, rad");
  canvas.text({80 + width, 686}, name + ", " + unit, palette::ink, Align::right, TextSize::title);
}

}  // namespace bounce
