#pragma once
#include "app/canvas.hpp"

namespace bounce {

/// The <canvas> of a web page: every call goes to the page's pen (docs/site/live/pen.js).
class PageCanvas final : public Canvas {
 public:
  void line(std::span<const Point> points, Colour colour, float width) override;
  void fill(std::span<const Point> convex, Colour colour) override;
  void circle(Point centre, float radius, Colour colour, float width) override;
  void disc(Point centre, float radius, Colour colour) override;
  void text(Point at, std::string_view words, Colour colour, Align align, TextSize size) override;
  void ball(Point centre, float radius, Colour tint) override;
  float text_width(std::string_view words, TextSize size) const override;
  std::string in_its_language(const std::string& sentence) const override;
  void push_clip(Rect area) override;
  void pop_clip() override;
};

}  // namespace bounce
