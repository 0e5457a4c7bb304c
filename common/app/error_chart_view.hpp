#pragma once
#include <optional>

#include "app/canvas.hpp"
#include "run/error_chart.hpp"

namespace bounce {

/// The chart of errors and costs: error across, cost up, both in powers of ten, as in the report. A
/// line a method, a dot a time step, and a ring round what the simulation uses now.
void draw_error_chart(Canvas& canvas, Rect area, const ErrorChart& chart, Method method, double dt);

/// What is at this place of it, if anything. `dt` is 0 for the exact solution, which has no steps.
std::optional<ErrorChart::Choice> error_chart_choice(Rect area, const ErrorChart& chart, Point at);

}  // namespace bounce
