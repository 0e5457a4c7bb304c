#pragma once
#include <SDL.h>

namespace bounce {

/// The sound of a ball that is hit: a short tone that dies out, made by formula. Without an audio
/// device there is silence, and no complaint.
class Sound {
 public:
  Sound();
  ~Sound();
  Sound(const Sound&) = delete;
  Sound& operator=(const Sound&) = delete;

  /// The faster the impact [m/s], the louder and the brighter.
  void knock(double impact_speed);

 private:
  SDL_AudioDeviceID device_ = 0;
};

}  // namespace bounce
