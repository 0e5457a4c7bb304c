#pragma once
#include <SDL.h>
#include <imgui.h>

#include <array>

#include "app/canvas.hpp"

namespace bounce {

/// Canvas over Dear ImGui's background draw list: its lines and shapes are anti-aliased, which
/// those of SDL_Renderer are not.
class ImGuiCanvas final : public Canvas {
 public:
  /// One font per TextSize; built-in ones where DejaVu Sans is not on the system. Also draws the
  /// pictures of balls, which share the fonts' texture.
  void load_fonts();

  void line(std::span<const Point> points, Colour colour, float width) override;
  void fill(std::span<const Point> convex, Colour colour) override;
  void circle(Point centre, float radius, Colour colour, float width) override;
  void disc(Point centre, float radius, Colour colour) override;
  void text(Point at, std::string_view words, Colour colour, Align align, TextSize size) override;
  void ball(Point centre, float radius, Colour tint) override;
  float text_width(std::string_view words, TextSize size) const override;
  void push_clip(Rect area) override;
  void pop_clip() override;

  bool dark = false;  // light and dark change places

 private:
  ImU32 ink(Colour colour) const;
  ImU32 filling(Colour colour) const;
  void load_fonts_into(ImFontAtlas& atlas);

  std::array<ImFont*, 4> fonts_{};  // of these heights [px]; ImGui 1.92 no longer keeps them
  std::array<float, 4> font_sizes_{13, 16, 18, 64};
  // Balls of these diameters [px]; the next larger one is drawn smaller.
  static constexpr std::array<int, 9> ball_sizes{8, 11, 16, 22, 32, 45, 64, 90, 128};
  std::array<int, ball_sizes.size()> ball_pictures_{};  // in the texture
};

/// Dear ImGui on SDL_Renderer. The library ships a backend of its own, but not in every package
/// (Debian's lacks it), and its name changes between versions; this one needs SDL 2.0.18 and
/// ImGui 1.86.
class ImGuiBackend {
 public:
  explicit ImGuiBackend(SDL_Renderer* renderer);
  ~ImGuiBackend();
  ImGuiBackend(const ImGuiBackend&) = delete;
  ImGuiBackend& operator=(const ImGuiBackend&) = delete;

  void upload_fonts();  // after all fonts are loaded
  void event(const SDL_Event& event);
  void begin_frame(int width, int height);
  void end_frame();  // draws

 private:
  SDL_Renderer* renderer_;
  SDL_Texture* font_ = nullptr;
};

}  // namespace bounce
