// The reader of --load, fed by libFuzzer. The first byte chooses the stage, the rest is the file
// without its checksum, which is put right: a damaged file is refused soon. The state must be one
// that can be saved again and reads back the same, or BadInput: nothing else.
//
// Bytes changed at random rarely make a file that is read to its end. So most changes here know
// what a file consists of: they replace the method, a value, or numbers of the state, and leave the
// rest valid.

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "all_stages.hpp"
#include "hostile_lines.hpp"
#include "run/save_load.hpp"

using namespace bounce;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Random = std::minstd_rand;

template <class All>
auto& one_of(All& all, Random& random) {
  return all[random() % std::size(all)];
}

/// Numbers at which readers go wrong: counts and phases, signs, halves, limits.
std::string interesting_number(Random& random) {
  static const std::vector<std::string> small{"0", "1", "2", "3", "-1"},
      numbers{"0",     "1",     "2",      "3",      "4",     "5",    "8",   "-1",
              "0.5",   "-0.5",  "1000",   "1e9",    "1e15",  "1e18", "2e9", "1e100",
              "-1e99", "1e-99", "1e-320", "-1e-15", "0.459", "nan"};
  return one_of(random() % 2 == 0 ? small : numbers, random);
}

/// Another number here, one more or less, or many fewer or more of them.
void change_numbers(std::vector<std::string>& numbers, Random& random) {
  const std::size_t at = random() % numbers.size();
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(at);
  switch (random() % 6) {
    case 0:
      numbers.insert(place, one_of(numbers, random));
      return;
    case 1:
      if (numbers.size() > 1) numbers.erase(place);
      return;
    case 2:
      numbers.resize(at + 1);
      return;
    case 3:
      numbers.resize(numbers.size() + 1 + random() % 40, interesting_number(random));
      return;
    default:  // at the beginning are counts: they are tried more often
      numbers[random() % 4 == 0 ? at % 4 : at] = interesting_number(random);
  }
}

/// One line "name value", changed.
void change_line(std::string& line, const test::Stage& stage, Random& random) {
  const std::size_t space = line.find(' ');
  if (space == std::string::npos) return;
  const std::string name = line.substr(0, space);
  if (name == "stage" || name == "bounce") return;
  if (name == "method") {
    const std::vector<Method> methods = stage.make()->methods();
    line = "method " + name_of(one_of(methods, random));
    return;
  }
  std::vector<std::string> numbers = split(line.substr(space + 1));
  change_numbers(numbers, random);
  line = name + " " + join(numbers, ",");
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  Random random(seed);
  random.discard(3);
  if (size < 2 || random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  const test::Stage& stage = test::all_stages()[data[0] % test::all_stages().size()];
  std::vector<std::string> lines =
      split(std::string(reinterpret_cast<const char*>(data) + 1, size - 1), '\n');
  // Mostly the state itself, in which each method and stage has its own way to remember.
  const bool in_state = random() % 3 != 0;
  for (std::string& line : lines) {
    const bool is_state = line.rfind("numbers ", 0) == 0 || line.rfind("raw ", 0) == 0;
    if (in_state ? is_state : random() % 8 == 0) change_line(line, stage, random);
  }
  const std::string text = join(lines, "\n");
  const std::size_t length = std::min(text.size(), most - 1);
  std::copy_n(text.begin(), length, data + 1);
  return length + 1;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("bounce_fuzz_" + std::to_string(getpid())))
          .string();
  const test::Stage& stage = test::all_stages()[data[0] % test::all_stages().size()];
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::ofstream(path, std::ios::binary) << test::with_checksum(text);
  std::unique_ptr<Simulation> simulation = stage.make(), again = stage.make();
  try {
    load_state(path, stage.name, stage.options, simulation);
  } catch (const BadInput&) {
    std::filesystem::remove(path);
    return 0;
  }
  const Simulation::Memory memory = simulation->memory();
  for (const double number : memory.numbers) {
    if (!std::isfinite(number)) std::abort();
  }
  save_state(path, stage.name, *simulation);
  // What we wrote, we must take: BadInput ends the run here.
  load_state(path, stage.name, stage.options, again);
  if (again->memory().numbers != memory.numbers) std::abort();
  std::filesystem::remove(path);
  return 0;
}
