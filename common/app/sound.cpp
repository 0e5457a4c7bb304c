#include "app/sound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace bounce {
namespace {

constexpr int samples_per_second = 44100;
constexpr double duration = 0.09;       // s
constexpr double fades_within = 0.018;  // s, to 1/e
constexpr double loudest_at = 6;        // m/s

}  // namespace

Sound::Sound() {
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return;
  SDL_AudioSpec wanted{};
  wanted.freq = samples_per_second;
  wanted.format = AUDIO_S16SYS;
  wanted.channels = 1;
  wanted.samples = 512;  // 12 ms: later than that, the ear notices
  device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
  if (device_ != 0) SDL_PauseAudioDevice(device_, 0);
}

Sound::~Sound() {
  if (device_ != 0) SDL_CloseAudioDevice(device_);
}

void Sound::knock(double impact_speed) {
  if (device_ == 0) return;
  const double strength = std::clamp(impact_speed / loudest_at, 0.05, 1.0);
  const double pitch = 220 + 260 * strength;  // Hz
  std::vector<std::int16_t> samples(static_cast<std::size_t>(duration * samples_per_second));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / samples_per_second;
    const double angle = 2 * std::numbers::pi * pitch * t;
    const double tone = 0.7 * std::sin(angle) + 0.3 * std::sin(2.76 * angle);  // as of a bar
    const double start = std::min(1.0, t / 0.001);                             // without a click
    const double loudness = 20000 * strength * start * std::exp(-t / fades_within);
    samples[i] = static_cast<std::int16_t>(loudness * tone);
  }
  SDL_ClearQueuedAudio(device_);
  SDL_QueueAudio(device_, samples.data(),
                 static_cast<Uint32>(samples.size() * sizeof(std::int16_t)));
}

}  // namespace bounce
