#include "app/imgui_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/palette.hpp"

namespace bounce {
namespace {

ImU32 to_imgui(Colour c) { return IM_COL32(c.red, c.green, c.blue, c.alpha); }
ImVec2 to_imgui(Point p) { return {p.x, p.y}; }

std::vector<ImVec2> to_imgui(std::span<const Point> points) {
  std::vector<ImVec2> all;
  all.reserve(points.size());
  for (const Point point : points) all.push_back(to_imgui(point));
  return all;
}

ImDrawList& list() { return *ImGui::GetBackgroundDrawList(); }

int segments(float radius) { return std::max(16, static_cast<int>(4 * std::sqrt(8 * radius))); }

/// The rectangle that these four corners are, in the order of draw_rect, if it is one of whole
/// pixels.
std::optional<Rect> whole_pixels(std::span<const Point> p) {
  if (p.size() != 4 || p[0].y != p[1].y || p[1].x != p[2].x || p[2].y != p[3].y ||
      p[3].x != p[0].x) {
    return std::nullopt;
  }
  for (const Point corner : p) {
    if (corner.x != std::round(corner.x) || corner.y != std::round(corner.y)) return std::nullopt;
  }
  return Rect{p[0].x, p[0].y, p[2].x - p[0].x, p[2].y - p[0].y};
}

/// A ball lit from the upper left, with an outline and smooth edges, as `size` x `size` pixels of
/// red, green, blue, alpha with rows `stride` pixels apart.
void paint_ball(std::uint32_t* pixels, int stride, int size) {
  const double radius = size / 2.0;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double x = (column + 0.5 - radius) / radius, y = (row + 0.5 - radius) / radius;
      const double from_centre = std::hypot(x, y);
      const double height = std::sqrt(std::max(0.0, 1 - from_centre * from_centre));
      const double light = std::max(0.0, -0.45 * x - 0.55 * y + 0.70 * height);
      double grey = 150 + 105 * light;
      // The outline: 1.5 px of ink, less on small balls, which would be all outline.
      const double width = std::min(1.5, 0.12 * size);
      const double outline = std::clamp(from_centre * radius - (radius - width), 0.0, 1.0);
      grey += (60 - grey) * outline;
      const double inside = std::clamp((1 - from_centre) * radius + 0.5, 0.0, 1.0);
      pixels[row * stride + column] =
          IM_COL32(static_cast<int>(grey), static_cast<int>(grey), static_cast<int>(grey),
                   static_cast<int>(255 * inside));
    }
  }
}

}  // namespace

void ImGuiCanvas::load_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  load_fonts_into(atlas);
  for (std::size_t i = 0; i < ball_sizes.size(); ++i) {
    ball_pictures_[i] = atlas.AddCustomRectRegular(ball_sizes[i], ball_sizes[i]);
  }
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);  // lays everything out
  for (std::size_t i = 0; i < ball_sizes.size(); ++i) {
    ImVec2 from, to;  // as parts of the whole: of what is in pixels the names differ by version
    atlas.CalcCustomRectUV(atlas.GetCustomRectByIndex(ball_pictures_[i]), &from, &to);
    const long x = std::lround(from.x * static_cast<float>(width));
    const long y = std::lround(from.y * static_cast<float>(height));
    paint_ball(reinterpret_cast<std::uint32_t*>(pixels) + y * width + x, width, ball_sizes[i]);
  }
}

void ImGuiCanvas::load_fonts_into(ImFontAtlas& atlas) {
  static constexpr const char* candidates[] = {
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",    // Debian, Ubuntu
      "/usr/share/fonts/TTF/DejaVuSans.ttf",                // Arch
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",  // Fedora
      "/System/Library/Fonts/Supplemental/Arial.ttf",       // macOS
      "C:/Windows/Fonts/segoeui.ttf"};
  ImFontConfig crisp;
  crisp.OversampleH = crisp.OversampleV = 1;
  crisp.PixelSnapH = true;
  for (const char* path : candidates) {
    if (!std::filesystem::exists(path)) continue;
    // The normal size first: ImGui takes the first font for its own widgets.
    fonts_[1] = atlas.AddFontFromFileTTF(path, font_sizes_[1], &crisp);
    fonts_[0] = atlas.AddFontFromFileTTF(path, font_sizes_[0], &crisp);
    fonts_[2] = atlas.AddFontFromFileTTF(path, font_sizes_[2], &crisp);
    static constexpr ImWchar digits[] = {'0', '9', 0};
    fonts_[3] = atlas.AddFontFromFileTTF(path, font_sizes_[3], &crisp, digits);
    return;
  }
  fonts_.fill(atlas.AddFontDefault());
  font_sizes_.fill(13);
}

ImU32 ImGuiCanvas::ink(Colour colour) const {
  return to_imgui(dark ? palette::darkened(colour) : colour);
}

/// A ball is lit in the dark, too: what is filled with its white and bluish grey stays as it is,
/// and so does a shadow.
ImU32 ImGuiCanvas::filling(Colour c) const {
  const auto [low, high] = std::minmax({c.red, c.green, c.blue});
  const bool stays = high == 0 || (c.blue >= c.red && c.blue > 90 && high - low <= 20);
  return stays ? to_imgui(c) : ink(c);
}

void ImGuiCanvas::line(std::span<const Point> points, Colour colour, float width) {
  if (points.size() < 2) return;
  const std::vector<ImVec2> path = to_imgui(points);
  list().AddPolyline(path.data(), static_cast<int>(path.size()), ink(colour), 0, width);
}

void ImGuiCanvas::fill(std::span<const Point> convex, Colour colour) {
  if (const auto box = whole_pixels(convex)) {  // sharp, and SDL's software renderer is quick
    list().AddRectFilled({box->x, box->y}, {box->right(), box->bottom()}, filling(colour));
    return;
  }
  const std::vector<ImVec2> path = to_imgui(convex);
  list().AddConvexPolyFilled(path.data(), static_cast<int>(path.size()), filling(colour));
}

void ImGuiCanvas::circle(Point centre, float radius, Colour colour, float width) {
  list().AddCircle(to_imgui(centre), radius, ink(colour), segments(radius), width);
}

void ImGuiCanvas::disc(Point centre, float radius, Colour colour) {
  list().AddCircleFilled(to_imgui(centre), radius, filling(colour), segments(radius));
}

void ImGuiCanvas::ball(Point centre, float radius, Colour tint) {
  // Whole pixels: then SDL's software renderer copies the picture, instead of drawing triangles.
  const float size = std::max(3.0f, std::round(2 * radius));
  std::size_t n = 0;
  while (n + 1 < ball_sizes.size() && static_cast<float>(ball_sizes[n]) < size) ++n;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImVec2 from, to;
  atlas.CalcCustomRectUV(atlas.GetCustomRectByIndex(ball_pictures_[n]), &from, &to);
  const ImVec2 corner{std::round(centre.x - size / 2), std::round(centre.y - size / 2)};
  list().AddImage(atlas.TexID, corner, {corner.x + size, corner.y + size}, from, to,
                  to_imgui(tint));
}

void ImGuiCanvas::text(Point at, std::string_view words, Colour colour, Align align,
                       TextSize size) {
  const float width = align == Align::left ? 0 : text_width(words, size);
  const float x = align == Align::left    ? at.x
                  : align == Align::right ? at.x - width
                                          : at.x - width / 2;
  ImFont* font = fonts_[static_cast<std::size_t>(size)];
  list().AddText(font, font_sizes_[static_cast<std::size_t>(size)],
                 {std::round(x), std::round(at.y)}, ink(colour), words.data(),
                 words.data() + words.size());
}

float ImGuiCanvas::text_width(std::string_view words, TextSize size) const {
  ImFont* font = fonts_[static_cast<std::size_t>(size)];
  const float height = font_sizes_[static_cast<std::size_t>(size)];
  return font->CalcTextSizeA(height, 1e9f, 0, words.data(), words.data() + words.size()).x;
}

void ImGuiCanvas::push_clip(Rect area) {
  list().PushClipRect({area.x, area.y}, {area.right(), area.bottom()}, true);
}

void ImGuiCanvas::pop_clip() { list().PopClipRect(); }

}  // namespace bounce
