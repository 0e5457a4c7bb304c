#include <iostream>

#include "app/demo.hpp"
#include "run/output_file.hpp"

// The app without a window, for builds in which SDL2 or Dear ImGui was not found.

namespace bounce {

bool has_window() { return false; }

bool show_window(const Demo& demo, std::unique_ptr<Simulation>, const Options&) {
  std::cerr << demo.stage.name
            << ": this build has no window (SDL2, Dear ImGui or libpng was missing); running "
               "without one\n";
  return false;
}

void save_picture(const Demo&, std::unique_ptr<Simulation>, const Options&, const std::string&) {
  throw MachineFailure(
      "--screenshot needs a build with SDL2, Dear ImGui and libpng, and this is none");
}

void record_clip(const Demo&, std::unique_ptr<Simulation>, const Options&, const std::string&) {
  throw MachineFailure("--record needs a build with SDL2, Dear ImGui and libpng, and this is none");
}

}  // namespace bounce
