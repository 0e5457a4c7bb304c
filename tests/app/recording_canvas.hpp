#pragma once
#include <vector>

#include "app/canvas.hpp"
#include "app/palette.hpp"

namespace bounce::test {

struct Arrow {
  Colour colour;
  Point from, to;  // px
  float x() const { return to.x - from.x; }
  float up() const { return from.y - to.y; }
};

/// Remembers the arrows that a picture draws, and nothing else. An arrow is a body of four corners
/// and a tip of three (draw_arrow); one of less than 6 px is a dot of 3 px.
class RecordingCanvas final : public Canvas {
 public:
  std::vector<Arrow> arrows;
  std::vector<Colour> dots;

  void fill(std::span<const Point> convex, Colour colour) override {
    if (convex.size() == 3 && body_.size() == 4 && colour.alpha == 255) {
      const Point from{(body_[0].x + body_[3].x) / 2, (body_[0].y + body_[3].y) / 2};
      arrows.push_back({colour, from, convex[1]});
    }
    body_.assign(convex.begin(), convex.end());
  }
  void disc(Point /*centre*/, float radius, Colour colour) override {
    if (radius == 3) dots.push_back(colour);
  }
  void line(std::span<const Point> /*points*/, Colour /*colour*/, float /*width*/) override {}
  void circle(Point /*centre*/, float /*radius*/, Colour /*colour*/, float /*width*/) override {}
  void text(Point /*at*/, std::string_view /*words*/, Colour /*colour*/, Align /*align*/,
            TextSize /*size*/) override {}
  void ball(Point /*centre*/, float /*radius*/, Colour /*tint*/) override {}
  float text_width(std::string_view words, TextSize /*size*/) const override {
    return 8 * static_cast<float>(words.size());
  }
  void push_clip(Rect /*area*/) override {}
  void pop_clip() override {}

 private:
  std::vector<Point> body_;  // what was filled last
};

inline bool same(Colour a, Colour b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
}

}  // namespace bounce::test
