#pragma once
#include <array>
#include <cstdio>
#include <string>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"

namespace bounce {

/// A frame with its scales.
struct Diagram {
  Rect box;
  Range across, up;

  Point at(double x, double y) const {
    const double u = (x - across.lowest) / (across.highest - across.lowest);
    const double v = (y - up.lowest) / (up.highest - up.lowest);
    return {box.x + static_cast<float>(u) * box.width,
            box.bottom() - static_cast<float>(v) * box.height};
  }
  void draw(Canvas& canvas, const std::string& title, const std::string& unit) const;
};

/// A plot's place, without the room for its numbers and its title.
inline Rect within_plot(Rect area) {
  return {area.x + 56, area.y + 26, area.width - 56 - 24, area.height - 52};
}

inline void Diagram::draw(Canvas& canvas, const std::string& title, const std::string& unit) const {
  canvas.text({box.x, box.y - 20}, title, palette::ink, Align::left, TextSize::normal);
  char text[32];
  for (const double y : ticks(up.lowest, up.highest, 4)) {
    const std::array<Point, 2> line{at(across.lowest, y), at(across.highest, y)};
    canvas.line(line, palette::grid_major, 1);
    std::snprintf(text, sizeof text, "%.3g", y);
    canvas.text({box.x - 6, line[0].y - 8}, text, palette::ink, Align::right, TextSize::tick);
  }
  for (const double x : ticks(across.lowest, across.highest, box.width > 500 ? 10 : 5)) {
    const std::array<Point, 2> line{at(x, up.lowest), at(x, up.highest)};
    canvas.line(line, palette::grid_minor, 1);
    std::snprintf(text, sizeof text, "%.3g ", x);
    canvas.text({line[0].x, box.bottom() + 4}, text + unit, palette::exact, Align::centre,
                TextSize::tick);
  }
}

}  // namespace bounce
