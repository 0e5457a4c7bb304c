// The three things that a program does with a window: show it, take a picture, record a clip.
#include <iostream>

#include "app/window.hpp"
#include "run/interrupt.hpp"
#include "run/save_load.hpp"

namespace bounce {

bool has_window() { return true; }

bool show_window(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options) {
  std::unique_ptr<Window> window;
  try {
    window = std::make_unique<Window>(demo, std::move(simulation), options, true);
  } catch (const MachineFailure& failure) {
    std::cerr << demo.stage.name << ": " << failure.what()
              << "; running without a window instead\n";
    return false;
  }
  double last = Playback::wall_clock(), frame = 1.0 / 60;
  catch_interrupts();
  while (window->tick(frame) && !interrupted()) {
    const double spent = Playback::wall_clock() - last;
    if (spent < 1.0 / 65)
      SDL_Delay(static_cast<Uint32>((1.0 / 62 - spent) * 1000));  // no vsync here
    frame = Playback::wall_clock() - last;
    last += frame;
  }
  if (!options.save.empty()) save_state(options.save, demo.stage, window->playback().simulation());
  return true;
}

void save_picture(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                  const std::string& path) {
  Window window(demo, std::move(simulation), options, false);
  window.view().forces = true;
  Playback& playback = window.playback();
  while (playback.shown_time() < options.duration && playback.trouble().empty()) {
    const double left = options.duration - playback.shown_time();
    playback.frame(left < 1.5 / 60 ? left : 1.0 / 60);
    if (left < 1e-9) break;
  }
  if (playback.is_refused()) throw BadInput(playback.trouble());
  window.keep_pixels = true;
  playback.paused = true;
  window.tick(0);  // Dear ImGui lays out in the first frame,
  window.tick(0);  // and draws in the second
  write_png(path, window.pixels());
}

void record_clip(const Demo& demo, std::unique_ptr<Simulation> simulation, const Options& options,
                 const std::string& path) {
  Recorder recorder(path);
  Window window(demo, std::move(simulation), options, false);
  window.view().forces = true;
  window.keep_pixels = true;
  catch_interrupts();
  const double frame = 1.0 / recorder.frames_per_second();
  const Playback& playback = window.playback();
  while (playback.shown_time() < options.duration && window.tick(frame) && !interrupted()) {
    recorder.add(window.pixels());
    if (!playback.trouble().empty()) break;  // its last picture says so
  }
  if (playback.is_refused()) throw BadInput(playback.trouble());
  recorder.finish();
}

}  // namespace bounce
