#pragma once
#include <string>

#include "app/canvas.hpp"
#include "physics/parameters.hpp"

namespace bounce {

/// One quantity against another: a box, and the numbers at its edges.
struct Diagram {
  Rect box;
  Range across, up;

  Point at(double x, double y) const {
    const double u = (x - across.lowest) / (across.highest - across.lowest);
    const double v = (y - up.lowest) / (up.highest - up.lowest);
    return {box.x + static_cast<float>(u) * box.width,
            box.bottom() - static_cast<float>(v) * box.height};
  }

  /// The title, and about so many lines with their numbers: below the box with a unit. `large` is
  /// for a picture that has the window to itself.
  void draw(Canvas& canvas, const std::string& title, int columns, int rows,
            const std::string& unit, bool large = false) const;
};

/// A plot's place, without the room for its title and its numbers; `right` is for those beside it.
inline Rect plot_box(Rect area, float right) {
  return {area.x + 56, area.y + 26, area.width - 56 - right, area.height - 52};
}

}  // namespace bounce
