#pragma once
#include <SDL.h>

#include <memory>

#include "app/demo.hpp"
#include "app/fingers.hpp"
#include "app/gamepad.hpp"
#include "app/imgui_canvas.hpp"
#include "app/key_map.hpp"
#include "app/keys.hpp"
#include "app/panel.hpp"
#include "app/picture_files.hpp"
#include "app/plots.hpp"
#include "app/pointer.hpp"
#include "app/sound.hpp"

namespace bounce {

/// SDL's video, for as long as this object lives. Throws MachineFailure when it does not start.
class Video {
 public:
  explicit Video(bool seen);  // not seen: draws in memory, on any machine
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
};

/// One demo in one window. All that happens in a frame happens in `tick`, so that whoever owns the
/// loop (this program, or a browser) only has to call it.
class Window {
 public:
  Window(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
         bool seen);

  /// One frame: events, `real_seconds` of movement, picture. Returns false when the user closed it.
  bool tick(double real_seconds);

  Playback& playback() { return playback_; }
  View& view() { return view_; }
  const Pixels& pixels() const { return pixels_; }  // of the last frame, with `keep_pixels`
  bool keep_pixels = false;

 private:
  void handle(const SDL_Event& event);
  void key(SDL_Keysym key);
  void touch(const SDL_TouchFingerEvent& finger);
  void begin_game();
  void read_keyboard_layout();
  void play_game(double real_seconds);
  void sound();
  void draw();
  void draw_plots();
  void draw_chart();
  void draw_help();
  void read_pixels();

  const Demo& demo_;
  bool seen_;
  // Each needs those above it, and is gone before them.
  Video video_;
  std::unique_ptr<SDL_Window, void (*)(SDL_Window*)> window_{nullptr, SDL_DestroyWindow};
  std::unique_ptr<SDL_Renderer, void (*)(SDL_Renderer*)> renderer_{nullptr, SDL_DestroyRenderer};
  std::unique_ptr<ImGuiBackend> backend_;
  ImGuiCanvas canvas_;
  Playback playback_;
  View view_;
  std::unique_ptr<Panel> panel_;
  PlotView plots_[2];
  ErrorChart chart_;

  Controls controls_;
  std::unique_ptr<Sound> sound_;  // empty where nobody listens
  long long knocks_ = 0;
  std::unique_ptr<Gamepad> gamepad_;  // of a game
  Fingers fingers_;
  KeyMap keys_;
  HeldBall held_;
  double clock_ = 0;  // real seconds since the start
  bool closed_ = false;
  std::string screenshot_;  // wanted after this frame
  Pixels pixels_;
};

}  // namespace bounce
