#include "app/error_chart_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/drawing.hpp"
#include "app/palette.hpp"

namespace bounce {
namespace {

constexpr double rounding = 1e-16,
                 nonsense = 10;  // m: smaller and larger errors are not told apart

/// The picture's box, and the powers of ten at its edges.
struct Axes {
  Rect box;
  int left = -4, right = 1, bottom = 1, top = 5;
  Point at(const ErrorChart::Dot& dot) const {
    const double error = std::log10(std::clamp(dot.error, rounding, nonsense));
    const double cost = std::log10(std::max(dot.evaluations, 1.0));
    return {box.x + box.width * static_cast<float>((error - left) / (right - left)),
            box.bottom() - box.height * static_cast<float>((cost - bottom) / (top - bottom))};
  }
};

Axes axes_for(Rect area, const ErrorChart& chart) {
  Axes axes{{area.x + 50, area.y + 58, area.width - 50 - 20, area.height - 58 - 178}};
  for (const ErrorChart::Dot& dot : chart.dots()) {
    if (!std::isfinite(dot.error)) continue;
    const double error = std::log10(std::clamp(dot.error, rounding, nonsense));
    const double cost = std::log10(std::max(dot.evaluations, 1.0));
    axes.left = std::min(axes.left, static_cast<int>(std::floor(error)));
    axes.bottom = std::min(axes.bottom, static_cast<int>(std::floor(cost)));
    axes.top = std::max(axes.top, static_cast<int>(std::ceil(cost)));
  }
  return axes;
}

/// The mark of a method, the same as in the report's figures.
void draw_mark(Canvas& canvas, Point at, Method method, Colour colour) {
  constexpr float r = 4.5f;
  const std::array<Point, 4> diamond{
      {{at.x, at.y - r - 1}, {at.x + r + 1, at.y}, {at.x, at.y + r + 1}, {at.x - r - 1, at.y}}};
  const std::array<Point, 3> up{{{at.x, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}}};
  const std::array<Point, 3> down{{{at.x, at.y + r}, {at.x - r, at.y - r}, {at.x + r, at.y - r}}};
  switch (method.mark) {
    case Mark::triangle:
      return canvas.fill(up, colour);
    case Mark::square:
      return draw_rect(canvas, {at.x - 4, at.y - 4, 8, 8}, colour);
    case Mark::diamond:
      return canvas.fill(diamond, colour);
    case Mark::open_diamond:
      canvas.fill(diamond, colour);
      return canvas.disc(at, 2, palette::paper);
    case Mark::triangle_down:
      return canvas.fill(down, colour);
    case Mark::disc:
      return canvas.disc(at, r, colour);
  }
}

std::vector<Method> methods_of(const ErrorChart& chart) {
  std::vector<Method> methods;
  for (const ErrorChart::Dot& dot : chart.dots()) {
    if (std::find(methods.begin(), methods.end(), dot.method) == methods.end()) {
      methods.push_back(dot.method);
    }
  }
  if (chart.offers(methods::exact)) methods.push_back(methods::exact);
  return methods;
}

/// The place of name i of `count` below, in two columns; a click on the last one, the exact
/// solution, chooses it.
Rect name_place(const Axes& axes, std::size_t i, std::size_t count) {
  const std::size_t rows = std::max<std::size_t>(4, (count + 1) / 2);
  const float height = 80 / static_cast<float>(rows);
  const float column = i < rows ? 0 : 1, row = static_cast<float>(i % rows);
  return {axes.box.x - 34 + 156 * column, axes.box.bottom() + 46 + height * row, 140, height};
}

void power_of_ten(Canvas& canvas, Point at, int power, Align align) {
  canvas.text(at, "1e" + std::to_string(power), palette::ink, align, TextSize::tick);
}

void draw_grid(Canvas& canvas, const Axes& axes) {
  const int step = axes.right - axes.left > 9 ? 4 : 2;
  for (int power = axes.right; power >= axes.left; power -= step) {
    const float x = axes.at({methods::exact, 0, 1, std::pow(10, power)}).x;
    draw_line(canvas, {x, axes.box.y}, {x, axes.box.bottom()}, palette::grid_major, 1);
    power_of_ten(canvas, {x, axes.box.bottom() + 4}, power, Align::centre);
  }
  for (int power = axes.bottom; power <= axes.top; ++power) {
    const float y = axes.at({methods::exact, 0, std::pow(10, power), 1}).y;
    draw_line(canvas, {axes.box.x, y}, {axes.box.right(), y}, palette::grid_major, 1);
    power_of_ten(canvas, {axes.box.x - 6, y - 8}, power, Align::right);
  }
}

void draw_methods(Canvas& canvas, const Axes& axes, const ErrorChart& chart, Method chosen) {
  const std::vector<Method> methods = methods_of(chart);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Colour colour = methods[i] == chosen ? palette::ink : palette::exact.faded(0.75);
    const Rect name = name_place(axes, i, methods.size());
    std::vector<ErrorChart::Dot> dots;
    for (const ErrorChart::Dot& dot : chart.dots()) {
      if (dot.method == methods[i] && dot.error <= nonsense) dots.push_back(dot);
    }
    std::sort(dots.begin(), dots.end(), [](const auto& a, const auto& b) { return a.dt > b.dt; });
    std::vector<Point> curve;
    for (const ErrorChart::Dot& dot : dots) curve.push_back(axes.at(dot));
    canvas.line(curve, colour, methods[i] == chosen ? 2.0f : 1.0f);
    for (const Point at : curve) draw_mark(canvas, at, methods[i], colour);
    if (methods[i] == methods::exact) {
      const std::array<Point, 2> dash{{{name.x - 4, name.y + 9}, {name.x + 8, name.y + 9}}};
      draw_dashed(canvas, dash, colour, 2);
    } else {
      draw_mark(canvas, {name.x + 2, name.y + 9}, methods[i], colour);
    }
    canvas.text({name.x + 14, name.y + 2}, name_of(methods[i]), colour, Align::left,
                TextSize::tick);
  }
}

/// Two lines on what the simulation uses now.
std::array<std::string, 2> sentence(const ErrorChart& chart, Method method, double dt) {
  if (method == methods::exact) return {"now: exact", "no steps, and no error but rounding"};
  if (method == methods::reference) return {"now: reference", "it chooses its steps itself"};
  const std::optional<ErrorChart::Dot> now = chart.now();
  char what[80], how[80];
  std::snprintf(what, sizeof what, "now: %s, dt %.4g s", name_of(method).c_str(), dt);
  if (!now) {
    return {what, chart.is_done() ? "too many steps to try them here" : "..."};
  }
  if (!(now->error <= nonsense)) return {what, "explodes"};
  std::snprintf(how, sizeof how, "%.4g evaluations per s, off by %s", now->evaluations,
                with_unit(now->error, "m").c_str());
  return {what, how};
}

}  // namespace

void draw_error_chart(Canvas& canvas, Rect area, const ErrorChart& chart, Method method,
                      double dt) {
  const bool nothing = !chart.trouble().empty();
  if (nothing) area.height = 68;
  draw_rect(canvas, area, palette::paper.faded(0.96));
  draw_frame(canvas, area, palette::ink, 1);
  canvas.text({area.x + 16, area.y + 10}, "speed against error", palette::ink, Align::left,
              TextSize::normal);
  if (nothing) {
    canvas.text({area.x + 16, area.y + 36}, chart.trouble(), palette::ink, Align::left,
                TextSize::tick);
    return;
  }
  const Axes axes = axes_for(area, chart);
  canvas.text({area.x + 16, area.y + 32}, "up: force evaluations per second", palette::exact,
              Align::left, TextSize::tick);
  char across[80];
  std::snprintf(across, sizeof across, "across: largest error in %.3g s [m]", chart.duration());
  canvas.text({axes.box.x + axes.box.width / 2, axes.box.bottom() + 22}, across, palette::exact,
              Align::centre, TextSize::tick);
  draw_grid(canvas, axes);
  draw_methods(canvas, axes, chart, method);
  if (const std::optional<ErrorChart::Dot> now = chart.now(); now && now->error <= nonsense) {
    draw_mark(canvas, axes.at(*now), method, palette::ink);
    canvas.circle(axes.at(*now), 9, palette::ink, 2);
  }
  const std::array<std::string, 2> lines = sentence(chart, method, dt);
  canvas.text({area.x + 16, area.bottom() - 42}, lines[0], palette::ink, Align::left,
              TextSize::tick);
  canvas.text({area.x + 16, area.bottom() - 24}, lines[1], palette::ink, Align::left,
              TextSize::tick);
}

std::optional<ErrorChart::Choice> error_chart_choice(Rect area, const ErrorChart& chart, Point at) {
  const Axes axes = axes_for(area, chart);
  const std::size_t names = methods_of(chart).size();
  const Rect exact = name_place(axes, names - 1, names);
  if (chart.offers(methods::exact) && at.x >= exact.x - 8 && at.x <= exact.right() &&
      at.y >= exact.y && at.y <= exact.bottom()) {
    return ErrorChart::Choice{methods::exact, 0};
  }
  std::optional<ErrorChart::Choice> nearest;
  float closest = 12;  // px
  for (const ErrorChart::Dot& dot : chart.dots()) {
    if (!(dot.error <= nonsense)) continue;
    const Point place = axes.at(dot);
    const float distance = std::hypot(place.x - at.x, place.y - at.y);
    if (distance >= closest) continue;
    closest = distance;
    nearest = ErrorChart::Choice{dot.method, dot.dt};
  }
  return nearest;
}

}  // namespace bounce
