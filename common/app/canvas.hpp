#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace bounce {

struct Point {
  float x, y;  // pixels, y down
};

struct Rect {
  float x, y, width, height;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
};

struct Colour {
  std::uint8_t red, green, blue, alpha = 255;
  constexpr Colour faded(double share) const {
    return {red, green, blue, static_cast<std::uint8_t>(alpha * share)};
  }
  /// `share` of the way to another one.
  constexpr Colour towards(Colour to, double share) const {
    const auto mix = [share](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(a + share * (b - a));
    };
    return {mix(red, to.red), mix(green, to.green), mix(blue, to.blue), mix(alpha, to.alpha)};
  }
};

enum class Align { left, centre, right };
enum class TextSize { tick, normal, title, score };  // 13, 16, 18 and 64 pixels

/// What pictures are drawn on. Pictures know nothing else of the window, so that they can be built,
/// and tested, without one.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void line(std::span<const Point> points, Colour colour, float width) = 0;
  virtual void fill(std::span<const Point> convex, Colour colour) = 0;
  virtual void circle(Point centre, float radius, Colour colour, float width) = 0;
  virtual void disc(Point centre, float radius, Colour colour) = 0;
  virtual void text(Point at, std::string_view words, Colour colour, Align align,
                    TextSize size) = 0;
  /// A shaded ball from a picture that was drawn beforehand: for many balls, a tenth of the cost of
  /// discs. `tint` multiplies its light grey.
  virtual void ball(Point centre, float radius, Colour tint) = 0;
  virtual float text_width(std::string_view words, TextSize size) const = 0;
  /// A sentence in the language that text() will write, to be broken into lines.
  virtual std::string in_its_language(const std::string& sentence) const { return sentence; }
  virtual void push_clip(Rect area) = 0;
  virtual void pop_clip() = 0;
};

}  // namespace bounce
