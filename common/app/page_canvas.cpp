#include "app/page_canvas.hpp"

#include <emscripten.h>

#include <array>

// clang-format off
EM_JS(void, pen_line, (const float* points, int count, unsigned colour, float width), { Module.pen.line(points >> 2, count, colour, width); });
EM_JS(void, pen_fill, (const float* points, int count, unsigned colour), { Module.pen.fill(points >> 2, count, colour); });
EM_JS(void, pen_circle, (float x, float y, float radius, unsigned colour, float width), { Module.pen.circle(x, y, radius, colour, width); });
EM_JS(void, pen_ball, (float x, float y, float radius, unsigned colour), { Module.pen.ball(x, y, radius, colour); });
EM_JS(void, pen_text, (float x, float y, const char* words, int length, unsigned colour, int align, int size), { Module.pen.text(x, y, UTF8ToString(words, length), colour, align, size); });
EM_JS(float, pen_width, (const char* words, int length, int size), { return Module.pen.width(UTF8ToString(words, length), size); });
EM_JS(int, pen_say, (const char* words, char* said, int size), { return stringToUTF8(Module.pen.say(UTF8ToString(words)), said, size); });
EM_JS(void, pen_push, (float x, float y, float width, float height), { Module.pen.push(x, y, width, height); });
EM_JS(void, pen_pop, (), { Module.pen.pop(); });
// clang-format on

namespace bounce {
namespace {

unsigned code(Colour c) {
  return (unsigned{c.red} << 24) | (unsigned{c.green} << 16) | (unsigned{c.blue} << 8) | c.alpha;
}
int count(std::span<const Point> points) { return static_cast<int>(points.size()); }

}  // namespace

void PageCanvas::line(std::span<const Point> points, Colour colour, float width) {
  if (points.size() > 1) pen_line(&points[0].x, count(points), code(colour), width);
}
void PageCanvas::fill(std::span<const Point> convex, Colour colour) {
  if (!convex.empty()) pen_fill(&convex[0].x, count(convex), code(colour));
}
void PageCanvas::circle(Point centre, float radius, Colour colour, float width) {
  pen_circle(centre.x, centre.y, radius, code(colour), width);
}
void PageCanvas::disc(Point centre, float radius, Colour colour) {
  pen_circle(centre.x, centre.y, radius, code(colour), 0);
}
void PageCanvas::ball(Point centre, float radius, Colour tint) {
  pen_ball(centre.x, centre.y, radius, code(tint));
}
void PageCanvas::text(Point at, std::string_view words, Colour colour, Align align, TextSize size) {
  pen_text(at.x, at.y, words.data(), static_cast<int>(words.size()), code(colour),
           static_cast<int>(align), static_cast<int>(size));
}
float PageCanvas::text_width(std::string_view words, TextSize size) const {
  return pen_width(words.data(), static_cast<int>(words.size()), static_cast<int>(size));
}
std::string PageCanvas::in_its_language(const std::string& sentence) const {
  std::array<char, 1000> said{};
  pen_say(sentence.c_str(), said.data(), static_cast<int>(said.size()));
  return said.data();
}
void PageCanvas::push_clip(Rect area) { pen_push(area.x, area.y, area.width, area.height); }
void PageCanvas::pop_clip() { pen_pop(); }

}  // namespace bounce
