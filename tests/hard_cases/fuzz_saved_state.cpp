// The reader of --load, fed by libFuzzer. The first byte chooses the stage, the rest is the file
// without its checksum, which is put right: a damaged file is refused soon. The state must be one
// that can be saved again and reads back the same, or BadInput: nothing else.

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "all_stages.hpp"
#include "hostile_lines.hpp"
#include "run/save_load.hpp"

using namespace bounce;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("bounce_fuzz_" + std::to_string(getpid())))
          .string();
  const test::Stage& stage = test::all_stages()[data[0] % test::all_stages().size()];
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::ofstream(path, std::ios::binary) << test::with_checksum(text);
  const std::unique_ptr<Simulation> simulation = stage.make(), again = stage.make();
  try {
    load_state(path, stage.name, *simulation);
  } catch (const BadInput&) {
    std::filesystem::remove(path);
    return 0;
  }
  const Simulation::Memory memory = simulation->memory();
  for (const double number : memory.numbers) {
    if (!std::isfinite(number)) std::abort();
  }
  save_state(path, stage.name, *simulation);
  load_state(path, stage.name, *again);  // what we wrote, we must take: BadInput ends the run here
  if (again->memory().numbers != memory.numbers) std::abort();
  std::filesystem::remove(path);
  return 0;
}
