// The reader of --balls, fed by libFuzzer with whatever its coverage leads to. It must give balls
// that are all in range, or say BadInput: nothing else.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "05_ball_collision/files/balls_file.hpp"

using namespace bounce;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("bounce_fuzz_" + std::to_string(getpid())))
          .string();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const Arrangement start = BallsFile(path).read();
    const auto within = [](const auto& all, double lowest, double highest) {
      return (all.array() >= lowest && all.array() <= highest).all();  // not so for a NaN
    };
    const bool in_range = start.mass.size() > 0 && within(start.balls.position, -1e15, 1e15) &&
                          within(start.balls.velocity, -1e15, 1e15) &&
                          within(start.mass, 1e-30, 1e30) && within(start.radius, 1e-30, 1e15);
    if (!in_range) std::abort();
  } catch (const BadInput&) {
  }
  std::filesystem::remove(path);
  return 0;
}
