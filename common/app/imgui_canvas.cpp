#include "app/imgui_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

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

void ImGuiCanvas::line(std::span<const Point> points, Colour colour, float width) {
  if (points.size() < 2) return;
  const std::vector<ImVec2> path = to_imgui(points);
  list().AddPolyline(path.data(), static_cast<int>(path.size()), to_imgui(colour), 0, width);
}

void ImGuiCanvas::fill(std::span<const Point> convex, Colour colour) {
  const std::vector<ImVec2> path = to_imgui(convex);
  list().AddConvexPolyFilled(path.data(), static_cast<int>(path.size()), to_imgui(colour));
}

void ImGuiCanvas::circle(Point centre, float radius, Colour colour, float width) {
  list().AddCircle(to_imgui(centre), radius, to_imgui(colour), segments(radius), width);
}

void ImGuiCanvas::disc(Point centre, float radius, Colour colour) {
  list().AddCircleFilled(to_imgui(centre), radius, to_imgui(colour), segments(radius));
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
                 {std::round(x), std::round(at.y)}, to_imgui(colour), words.data(),
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

ImGuiBackend::ImGuiBackend(SDL_Renderer* renderer) : renderer_(renderer) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // or it leaves an imgui.ini in the working folder
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

ImGuiBackend::~ImGuiBackend() {
  if (font_ != nullptr) SDL_DestroyTexture(font_);
  ImGui::DestroyContext();
}

void ImGuiBackend::upload_fonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  font_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ABGR8888, SDL_TEXTUREACCESS_STATIC, width,
                            height);
  SDL_UpdateTexture(font_, nullptr, pixels, 4 * width);
  SDL_SetTextureBlendMode(font_, SDL_BLENDMODE_BLEND);
  atlas.SetTexID(reinterpret_cast<ImTextureID>(font_));
}

void ImGuiBackend::event(const SDL_Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION:
      io.MousePos = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
      break;
    case SDL_MOUSEWHEEL:
      io.MouseWheel += static_cast<float>(event.wheel.y);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      io.MousePos = {static_cast<float>(event.button.x), static_cast<float>(event.button.y)};
      if (event.button.button == SDL_BUTTON_LEFT)
        io.MouseDown[0] = event.type == SDL_MOUSEBUTTONDOWN;
      break;
    default:
      break;
  }
}

void ImGuiBackend::begin_frame(int width, int height) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = 1.0f / 60;  // fixed: the same frames every time
  ImGui::NewFrame();
}

void ImGuiBackend::end_frame() {
  ImGui::Render();
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& commands = *data.CmdLists[n];
    for (const ImDrawCmd& command : commands.CmdBuffer) {
      const SDL_Rect clip{static_cast<int>(command.ClipRect.x),
                          static_cast<int>(command.ClipRect.y),
                          static_cast<int>(command.ClipRect.z - command.ClipRect.x),
                          static_cast<int>(command.ClipRect.w - command.ClipRect.y)};
      if (clip.w <= 0 || clip.h <= 0) continue;
      SDL_RenderSetClipRect(renderer_, &clip);
      const auto* vertices =
          reinterpret_cast<const char*>(commands.VtxBuffer.Data + command.VtxOffset);
      const auto at = [vertices](std::size_t offset) { return vertices + offset; };
      SDL_RenderGeometryRaw(
          renderer_, reinterpret_cast<SDL_Texture*>(command.GetTexID()),
          reinterpret_cast<const float*>(at(offsetof(ImDrawVert, pos))), sizeof(ImDrawVert),
          reinterpret_cast<const SDL_Color*>(at(offsetof(ImDrawVert, col))), sizeof(ImDrawVert),
          reinterpret_cast<const float*>(at(offsetof(ImDrawVert, uv))), sizeof(ImDrawVert),
          commands.VtxBuffer.Size - static_cast<int>(command.VtxOffset),
          commands.IdxBuffer.Data + command.IdxOffset, static_cast<int>(command.ElemCount),
          sizeof(ImDrawIdx));
    }
  }
  SDL_RenderSetClipRect(renderer_, nullptr);
}

}  // namespace bounce
