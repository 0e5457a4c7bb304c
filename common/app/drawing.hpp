#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/canvas.hpp"

namespace bounce {

/// From world metres (y up) to pixels (y down), the same scale both ways.
struct SideCamera {
  Point origin;     // where height 0 at the ball's column is, in pixels
  float per_metre;  // pixels
  Point at(double x, double y) const {
    return {origin.x + static_cast<float>(x) * per_metre,
            origin.y - static_cast<float>(y) * per_metre};
  }
  float length(double metres) const { return static_cast<float>(metres) * per_metre; }
};

enum class Shaft { force, velocity };  // thin; fat with an outline: told apart without colour

void draw_arrow(Canvas& canvas, Point from, Point to, Colour colour, Shaft shaft = Shaft::force);
void draw_line(Canvas& canvas, Point from, Point to, Colour colour, float width);
void draw_dashed(Canvas& canvas, std::span<const Point> points, Colour colour, float width);
void draw_dashed_circle(Canvas& canvas, Point centre, float radius, Colour colour, float width);
void draw_rect(Canvas& canvas, Rect area, Colour colour);
void draw_frame(Canvas& canvas, Rect area, Colour colour, float width);

/// Flat ball with an outline and a small mark.
void draw_ball(Canvas& canvas, Point centre, float radius);

/// Level ground: a line with hatching below.
void draw_ground(Canvas& canvas, float left, float right, float y);

/// Text on a paper-coloured plate, so that it can be read over lines.
void draw_label(Canvas& canvas, Point at, std::string_view words, Colour colour,
                Align align = Align::left, TextSize size = TextSize::tick);

/// Arrow length [px] for a force: 24 px for the ball's weight, and growing with the square root, so
/// that a contact of 40 weights still fits. The picture says "length ~ sqrt(force)".
float force_length(double force, double weight);

/// Round numbers 1, 2, 5 x 10^n that cut [low, high] into about `count` parts.
std::vector<double> ticks(double low, double high, int count);

/// "12.3 mm", "0.456 s": three significant digits and a unit with a prefix that fits.
std::string with_unit(double value, const std::string& unit);

}  // namespace bounce
