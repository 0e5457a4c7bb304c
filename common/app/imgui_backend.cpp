// Dear ImGui on SDL_Renderer.
#include <cstddef>

#include "app/imgui_canvas.hpp"

namespace bounce {

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
