#include "app/plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/palette.hpp"

namespace bounce {
namespace {

constexpr double window_length = 4;  // s

/// The next of 1, 2, 5 x 10^n from `value` outwards, keeping its sign.
double outward(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double power = std::pow(10, std::floor(std::log10(std::abs(value))));
  for (const double mantissa : {1.0, 2.0, 5.0}) {
    if (std::abs(value) <= mantissa * power * (1 + 1e-9))
      return std::copysign(mantissa * power, value);
  }
  return std::copysign(10 * power, value);
}

}  // namespace

void PlotView::draw(Canvas& canvas, Rect area, const Plot& plot, const Playback& playback) {
  const double now = playback.shown_time();
  if (now < last_time_) top_ = bottom_ = 0;
  last_time_ = now;
  const double from = std::max(0.0, now - window_length);

  std::vector<const TracePoint*> points;
  std::vector<double> values;
  for (const TracePoint& point : playback.trace()) {
    // `now` is a sum of pieces: rounded, it may end just before the step that it shows.
    if (point.t < from - 0.05 || point.t > now + 1e-9) continue;
    points.push_back(&point);
    values.push_back(plot.value(point));
  }
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (value > top_) top_ = outward(value);
    if (value < bottom_) bottom_ = outward(value);
  }
  const Diagram diagram{
      plot_box(area, 72), {from, from + window_length}, {bottom_, top_ == bottom_ ? 1 : top_}};
  const Rect& box = diagram.box;

  diagram.draw(canvas, plot.title, 4, 3, " s");
  canvas.text({box.x + canvas.text_width(plot.title, TextSize::normal) + 8, area.y + 8}, plot.unit,
              palette::exact, Align::left, TextSize::tick);

  canvas.push_clip({box.x - 1, box.y - 2, box.width + 2, box.height + 4});
  std::vector<Point> curve, exact;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TracePoint& point = *points[i];
    if (i > 0 && point.energy.spring > 0) {
      const float left = diagram.at(points[i - 1]->t, 0).x, right = diagram.at(point.t, 0).x;
      draw_rect(canvas, {left, box.y, std::max(1.0f, right - left), box.height},
                palette::spring.faded(0.08));
    }
    if (std::isfinite(values[i])) curve.push_back(diagram.at(point.t, values[i]));
    if (plot.exact && !point.exact.empty()) exact.push_back(diagram.at(point.t, plot.exact(point)));
  }
  canvas.line(curve, plot.colour, 2);
  draw_dashed(canvas, exact, palette::exact, 1.5f);
  canvas.pop_clip();

  if (!curve.empty()) {
    const Point end = curve.back();
    canvas.disc(end, 3.5f, plot.colour);
    char text[32];
    std::snprintf(text, sizeof text, "%+.3g", values.back() + 0.0);
    const float y = std::clamp(end.y, box.y, box.bottom());
    draw_label(canvas, {box.right() + 8, y - 8}, text, palette::ink, Align::left, TextSize::normal);
  }
}

void draw_energy_column(Canvas& canvas, Rect area, const TracePoint& now) {
  struct Part {
    double energy;
    Colour colour;
    const char* name;
  };
  // A ball below height 0 has negative energy of height: then its own height counts as zero.
  const double lowest = std::min(0.0, now.energy.gravitational);
  const std::array<Part, 4> parts{{{now.energy.gravitational - lowest, palette::gravity, "height"},
                                   {now.energy.spring, palette::spring, "spring"},
                                   {now.energy.kinetic, palette::motion, "motion"},
                                   {now.lost, palette::damper, "lost"}}};
  const double scale = std::max(std::abs(now.before - lowest), 1e-300);
  const float full = area.height * 0.52f, ground = area.bottom() - 92;
  const Rect column{area.x + 12, ground - full, 34, full};
  canvas.text({area.x + 12, area.y + 12}, "energy", palette::ink, Align::left, TextSize::normal);

  canvas.push_clip({area.x, area.y + 78, area.width, ground - area.y - 77});
  float y = ground;
  for (const Part& part : parts) {
    const auto height =
        static_cast<float>(std::min(3.0, std::max(0.0, part.energy) / scale)) * full;
    if (height < 0.5f) continue;
    draw_rect(canvas, {column.x, y - height, column.width, height}, part.colour);
    if (&part == &parts[3]) {  // hatched: this energy is gone
      for (float line = y - height; line < y; line += 6) {
        draw_line(canvas, {column.x, line + 6}, {column.right(), line}, palette::paper.faded(0.7),
                  1);
      }
    }
    y -= height;
  }
  draw_frame(canvas, column, palette::ink, 1.5f);

  // The hair: error x 100, from the top of the outline.
  const double error = now.energy_error() / scale;
  const float x = column.right() + 12;
  const float tip = column.y - static_cast<float>(std::clamp(100 * error, -1.0, 0.28)) * full;
  draw_line(canvas, {column.right(), column.y}, {x + 6, column.y}, palette::ink, 1);
  draw_arrow(canvas, {x, column.y}, {x, tip}, palette::ink);
  canvas.pop_clip();

  char text[32];
  std::snprintf(text, sizeof text, "%+.*g %%", std::abs(error) < 1 ? 2 : 3, 100 * error);
  canvas.text({area.x + 4, area.y + 34}, "error", palette::ink, Align::left, TextSize::tick);
  canvas.text({area.x + 4, area.y + 48}, std::abs(error) < 1e-9 ? "0 %" : text, palette::ink,
              Align::left, TextSize::tick);
  canvas.text({area.x + 4, area.y + 62}, "arrow: x100", palette::exact, Align::left,
              TextSize::tick);
  y = ground + 10;
  for (const Part& part : parts) {
    draw_rect(canvas, {area.x + 6, y + 3, 10, 10}, part.colour);
    canvas.text({area.x + 22, y}, part.name, palette::ink, Align::left, TextSize::tick);
    y += 18;
  }
}

}  // namespace bounce
