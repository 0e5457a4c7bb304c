#include "app/drawing.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/palette.hpp"

namespace bounce {
namespace {

float distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

Point between(Point a, Point b, float share) {
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

}  // namespace

void draw_arrow(Canvas& canvas, Point from, Point to, Colour colour, Shaft shaft) {
  const float length = distance(from, to);
  if (length <= 0) return;
  if (length < 6) return canvas.disc(from, 3, colour);
  const bool fat = shaft == Shaft::velocity;
  const float half = fat ? 4.0f : 1.5f;
  const float shrink = std::min(1.0f, length / (fat ? 28.0f : 24.0f));  // short arrow, small head
  const float head = (fat ? 14.0f : 12.0f) * shrink, wing = (fat ? 6.5f : 5.5f) * shrink;
  const float ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const auto at = [&](float along, float across) {
    return Point{from.x + ux * along - uy * across, from.y + uy * along + ux * across};
  };
  const float neck = length - head;
  const std::array<Point, 4> body{at(0, half), at(neck, half), at(neck, -half), at(0, -half)};
  const std::array<Point, 3> tip{at(neck, wing), at(length, 0), at(neck, -wing)};
  canvas.fill(body, colour);
  canvas.fill(tip, colour);
  if (fat) {
    const std::array<Point, 8> outline{at(0, half),   at(neck, half),  at(neck, wing),
                                       at(length, 0), at(neck, -wing), at(neck, -half),
                                       at(0, -half),  at(0, half)};
    canvas.line(outline, palette::ink, 1);
  }
}

void draw_line(Canvas& canvas, Point from, Point to, Colour colour, float width) {
  canvas.line(std::array{from, to}, colour, width);
}

void draw_dashed(Canvas& canvas, std::span<const Point> points, Colour colour, float width) {
  constexpr float dash = 6, gap = 4;
  float along = 0;  // of the pattern
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const float length = distance(points[i], points[i + 1]);
    for (float done = 0; done < length;) {
      const bool on = along < dash;
      const float step = std::min(length - done, (on ? dash : dash + gap) - along);
      if (on) {
        draw_line(canvas, between(points[i], points[i + 1], done / length),
                  between(points[i], points[i + 1], (done + step) / length), colour, width);
      }
      done += std::max(step, 1e-3f);
      along += step;
      if (along >= dash + gap) along = 0;
    }
  }
}

void draw_dashed_circle(Canvas& canvas, Point centre, float radius, Colour colour, float width) {
  const int dashes = std::max(8, static_cast<int>(2 * std::numbers::pi * radius / 10));
  for (int i = 0; i < dashes; ++i) {
    std::array<Point, 5> arc;
    for (int k = 0; k < 5; ++k) {
      const double angle = 2 * std::numbers::pi * (i + 0.6 * k / 4) / dashes;
      arc[static_cast<std::size_t>(k)] = {centre.x + radius * static_cast<float>(std::cos(angle)),
                                          centre.y + radius * static_cast<float>(std::sin(angle))};
    }
    canvas.line(arc, colour, width);
  }
}

void draw_rect(Canvas& canvas, Rect area, Colour colour) {
  const std::array<Point, 4> corners{{{area.x, area.y},
                                      {area.right(), area.y},
                                      {area.right(), area.bottom()},
                                      {area.x, area.bottom()}}};
  canvas.fill(corners, colour);
}

void draw_frame(Canvas& canvas, Rect area, Colour colour, float width) {
  const std::array<Point, 5> corners{{{area.x, area.y},
                                      {area.right(), area.y},
                                      {area.right(), area.bottom()},
                                      {area.x, area.bottom()},
                                      {area.x, area.y}}};
  canvas.line(corners, colour, width);
}

void draw_ball(Canvas& canvas, Point centre, float radius) {
  canvas.disc(centre, radius, palette::ball);
  canvas.circle(centre, radius, palette::ink, 1.5f);
  canvas.disc(centre, 2.5f, palette::ink);
}

void draw_ground(Canvas& canvas, float left, float right, float y) {
  draw_line(canvas, {left, y}, {right, y}, palette::ink, 2);
  for (float x = left + 8; x < right; x += 12) {
    draw_line(canvas, {x, y + 1}, {x - 8, y + 9}, palette::ink.faded(0.45), 1);
  }
}

void draw_label(Canvas& canvas, Point at, std::string_view words, Colour colour, Align align,
                TextSize size) {
  const float width = canvas.text_width(words, size);
  const float height = size == TextSize::tick ? 15 : 19;
  const float left = align == Align::left    ? at.x
                     : align == Align::right ? at.x - width
                                             : at.x - width / 2;
  draw_rect(canvas, {left - 3, at.y - 1, width + 6, height}, palette::paper.faded(0.8));
  canvas.text(at, words, colour, align, size);
}

float force_length(double force, double weight) {
  if (!(weight > 0)) weight = 1;  // no gravity: relative to 1 N
  return 24 * static_cast<float>(std::sqrt(std::abs(force) / weight));
}

std::vector<double> ticks(double low, double high, int count) {
  const double rough = (high - low) / count;
  if (!(rough > 0) || !std::isfinite(rough)) return {};
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double mantissa : {5.0, 2.0, 1.0}) {
    if (rough <= mantissa * power) step = mantissa * power;
  }
  std::vector<double> all;
  const double first = std::ceil(low / step - 1e-9);
  for (double n = first; n * step <= high + 1e-9 * step && all.size() < 100; ++n) {
    all.push_back(n == 0 ? 0 : n * step);  // never "-0"
  }
  return all;
}

std::string with_unit(double value, const std::string& unit) {
  const double size = std::abs(value);
  struct Prefix {
    double from, factor;
    const char* name;
  };
  static constexpr Prefix prefixes[] = {{1e9, 1e-9, "G"}, {1e6, 1e-6, "M"},  {1e4, 1e-3, "k"},
                                        {0.1, 1, ""},     {1e-3, 1e3, "m"},  {1e-6, 1e6, "u"},
                                        {1e-9, 1e9, "n"}, {1e-12, 1e12, "p"}};
  if (size == 0) return "0 " + unit;
  for (const Prefix& prefix : prefixes) {
    if (size < prefix.from) continue;
    char text[48];
    std::snprintf(text, sizeof text, "%.3g %s%s", value * prefix.factor, prefix.name, unit.c_str());
    return text;
  }
  char text[48];
  std::snprintf(text, sizeof text, "%.1e %s", value, unit.c_str());
  return text;
}

}  // namespace bounce
