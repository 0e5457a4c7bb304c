#pragma once
#include <SDL.h>

#include <memory>

#include "app/demo.hpp"

namespace bounce {

/// How far a stick is pushed, from -1 to 1. Sticks do not come back to their middle by themselves:
/// the first 15 % are nothing.
constexpr double stick(int raw) {
  constexpr double dead = 0.15;
  const double share = raw / 32767.0, size = share < 0 ? -share : share;
  if (size < dead) return 0;
  const double out = size > 1 ? 1 : (size - dead) / (1 - dead);
  return share < 0 ? -out : out;
}

/// One game controller, whichever came last; it may come and go while the game runs. The left stick
/// moves the racket, the right one tilts it, a button or a trigger swings, and Back is the key of
/// the modes.
class Gamepad {
 public:
  Gamepad();
  ~Gamepad();

  bool is_there() const { return pad_ != nullptr; }
  void handle(const SDL_Event& event, Controls& controls);
  /// What it does now. Where there is none, nothing.
  void read(Controls& controls) const;

 private:
  std::unique_ptr<SDL_GameController, void (*)(SDL_GameController*)> pad_{nullptr,
                                                                          SDL_GameControllerClose};
};

}  // namespace bounce
