#pragma once
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "run/output_file.hpp"

namespace bounce {

/// A picture as rows of red, green, blue bytes.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Writes a PNG. Throws BadInput or MachineFailure.
void write_png(const std::string& path, const Pixels& pixels);

/// Pipes frames into ffmpeg, which makes a GIF or an MP4 of them.
class Recorder {
 public:
  /// Throws BadInput for a path that ends in neither .gif nor .mp4 or cannot be written, and
  /// MachineFailure where ffmpeg is missing.
  explicit Recorder(const std::string& path);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  int frames_per_second() const { return is_gif_ ? 25 : 30; }
  void add(const Pixels& pixels);
  void finish();

 private:
  std::string path_;
  bool is_gif_;
  OutputFile file_;
  std::FILE* pipe_ = nullptr;
};

}  // namespace bounce
