#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/canvas.hpp"

namespace bounce {

/// In a heap most balls are hidden by others, and drawing is what costs time. This looks at the
/// picture as squares of a few pixels, balls from the nearest to the furthest: who finds all its
/// squares covered by nearer balls cannot be seen.
class Cover {
 public:
  explicit Cover(Rect area)
      : area_(area),
        columns_(static_cast<int>(area.width / side) + 1),
        rows_(static_cast<int>(area.height / side) + 1),
        covered_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), false) {}

  /// Whether anything of this disc is still to be seen; covers what it hides from now on.
  bool add(Point centre, float radius) {
    bool seen = false;
    const float x = centre.x - area_.x, y = centre.y - area_.y;
    const auto square = [](float pixels) { return static_cast<int>(std::floor(pixels / side)); };
    const int first_row = std::max(0, square(y - radius));
    const int last_row = std::min(rows_ - 1, square(y + radius));
    const int first_column = std::max(0, square(x - radius));
    const int last_column = std::min(columns_ - 1, square(x + radius));
    constexpr float corner = 0.71f * side;  // from a square's centre to its corner
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const float dx = (static_cast<float>(column) + 0.5f) * side - x;
        const float dy = (static_cast<float>(row) + 0.5f) * side - y;
        const float distance = std::hypot(dx, dy);
        if (distance > radius + corner) continue;
        const auto at = static_cast<std::size_t>(row * columns_ + column);
        seen = seen || !covered_[at];
        if (distance < radius - corner) covered_[at] = true;  // the whole square
      }
    }
    return seen;
  }

 private:
  static constexpr float side = 4;  // px

  Rect area_;
  int columns_, rows_;
  std::vector<bool> covered_;
};

}  // namespace bounce
