#include "run/save_load.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>

#include "run/input_file.hpp"
#include "run/output_file.hpp"

namespace bounce {
namespace {

// Version 1 had no raw numbers, and is still read.
constexpr int version = 2;
constexpr std::string_view first_words = "bounce state, version ";

// So many numbers can be read by people; more are written as they stand in memory: a million balls
// take 88 MB instead of 200, and are written and read at the speed of the disk.
constexpr std::size_t most_readable = 1000;

/// FNV-1a, 64 bit: enough to notice a damaged file.
std::string checksum(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  }
  std::ostringstream hex;
  hex << std::hex << hash;
  return hex.str();
}

constexpr const char* made_by = "it must be a file that --save wrote for this stage";

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw BadInput("--load '" + path + "' is not allowed: " + why + "; " + made_by);
}

/// Eight bytes a number, the lowest first on every machine.
void append_raw(std::string& text, const std::vector<double>& numbers) {
  text.reserve(text.size() + 8 * numbers.size() + 100);
  for (const double number : numbers) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    char bytes[8];
    for (int i = 0; i < 8; ++i) bytes[i] = static_cast<char>((bits >> (8 * i)) & 0xff);
    text.append(bytes, 8);
  }
}

std::vector<double> read_raw(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / 8);
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      bits |= std::uint64_t{static_cast<unsigned char>(bytes[8 * n + i])} << (8 * i);
    }
    std::memcpy(&numbers[n], &bits, sizeof bits);
  }
  return numbers;
}

/// "name value" lines, the parameters as "set.NAME value".
using Lines = std::map<std::string, std::string>;

double number_of(const std::string& path, const Lines& lines, const std::string& name, Range valid,
                 bool is_whole = false) {
  const auto found = lines.find(name);
  const std::optional<double> value =
      found == lines.end() ? std::nullopt : parse_number_in(found->second, valid, is_whole);
  if (value) return *value;
  refuse(path, "its " + name +
                   (found == lines.end() ? " is missing" : " is '" + found->second + "'") +
                   ", and it must be " + number_in(valid, "", is_whole));
}

/// The same for what is counted.
long long count_of(const std::string& path, const Lines& lines, const std::string& name) {
  return static_cast<long long>(number_of(path, lines, name, Simulation::valid_count, true));
}

std::string read_text(const std::string& path) {
  std::string text = InputFile("--load", path, made_by).whole();
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // some editors' mark
  // Another system's ends of lines. (Where numbers stand raw they would be damage, and stay so.)
  const std::size_t first_end = text.find('\n');
  if (first_end != text.npos && first_end > 0 && text[first_end - 1] == '\r') {
    std::erase(text, '\r');
  }
  return text;
}

/// What is between the first line and the checksum, if all is well.
std::string_view checked(const std::string& path, std::string_view text) {
  const std::size_t first_end = text.find('\n');
  if (text.rfind(first_words, 0) != 0 || first_end == text.npos) {
    refuse(path, "it does not begin as a saved state does");
  }
  const std::string its(text.substr(first_words.size(), first_end - first_words.size()));
  const std::optional<double> its_version = parse_number(its);
  if (!its_version || *its_version < 1) refuse(path, "it has no version");
  if (*its_version > version) {
    refuse(path, "a newer program wrote it (version " + its + "; this one knows up to " +
                     std::to_string(version) + ")");
  }
  const std::size_t last = text.rfind("checksum ");
  if (last == text.npos ||
      text.substr(last) != "checksum " + checksum(text.substr(0, last)) + "\n") {
    refuse(path, "it is damaged (its checksum does not fit)");
  }
  return text.substr(first_end + 1, last - first_end - 1);
}

/// Takes lines off `body`, up to and with the one that says how many raw numbers follow.
Lines take_lines(std::string_view& body) {
  Lines lines;
  while (!body.empty() && !lines.count("raw")) {
    const std::size_t end = std::min(body.find('\n'), body.size() - 1);
    const std::string line(body.substr(0, end));
    const std::size_t space = line.find(' ');
    if (space != line.npos) lines[line.substr(0, space)] = line.substr(space + 1);
    body.remove_prefix(end + 1);
  }
  return lines;
}

/// The numbers of the state: in words, or raw behind the lines.
std::vector<double> numbers_from(const std::string& path, const Lines& lines,
                                 std::string_view behind) {
  std::vector<double> numbers;
  if (lines.count("raw")) {
    if (static_cast<double>(behind.size()) !=
        8 * static_cast<double>(count_of(path, lines, "raw")) + 1)
      refuse(path, "it is not complete");
    numbers = read_raw(behind.substr(0, behind.size() - 1));
  } else {
    if (!lines.count("numbers")) refuse(path, "it is not complete: the state is missing");
    for (const std::string& word : split(lines.at("numbers"))) {
      const std::optional<double> number = parse_number(word);
      if (!number) {
        refuse(path, "its state's number " + std::to_string(numbers.size() + 1) + " is '" + word +
                         "', and it must be " + number_in(Simulation::valid_number));
      }
      numbers.push_back(*number);
    }
  }
  if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) {
    refuse(path, "its state is not all numbers");
  }
  return numbers;
}

}  // namespace

void save_state(const std::string& path, const StageName& stage, Simulation& simulation) {
  const Simulation::Memory memory = simulation.memory();
  std::string text = std::string(first_words) + std::to_string(version) + "\n";
  text += "stage " + stage.name + "\n";
  text += "method " + name_of(simulation.method()) + "\n";
  for (const auto& [option, value] : simulation.traits().saved_options) {
    text += "option." + option + " " + value + "\n";
  }
  for (const Parameter& parameter : simulation.parameters()) {
    text += "set." + parameter.name + " " + parameter.text() + "\n";
  }
  text += "time " + to_text(memory.time) + "\n";
  text += "dt " + to_text(memory.dt) + "\n";
  text += "tolerance " + to_text(memory.tolerance) + "\n";
  text += "grid_start " + to_text(memory.grid_start) + "\n";
  text += "grid_steps " + std::to_string(memory.grid_steps) + "\n";
  text += "into_step " + to_text(memory.into_step) + "\n";
  text += "steps " + std::to_string(memory.steps) + "\n";
  if (memory.numbers.size() <= most_readable) {
    text += "numbers " + to_text(memory.numbers) + "\n";
  } else {
    text += "raw " + std::to_string(memory.numbers.size()) + "\n";
    append_raw(text, memory.numbers);
    text += "\n";
  }
  text += "checksum " + checksum(text) + "\n";

  OutputFile file("--save", path);
  file.write(text);
  file.finish();
}

std::map<std::string, std::string> saved_options(const std::string& path) {
  const std::string text = read_text(path);
  std::string_view body = checked(path, text);
  std::map<std::string, std::string> options;
  for (const auto& [name, value] : take_lines(body)) {
    if (name.rfind("option.", 0) == 0) options[name.substr(7)] = value;
  }
  return options;
}

void load_state(const std::string& path, const StageName& stage, Simulation& simulation) {
  const std::string text = read_text(path);
  std::string_view body = checked(path, text);
  const Lines lines = take_lines(body);
  if (!lines.count("stage") || lines.at("stage") != stage.name) {
    const std::string its = lines.count("stage") ? "is '" + lines.at("stage") + "'" : "is missing";
    refuse(path, "its stage " + its + ", and it must be '" + stage.name + "'");
  }
  for (const Parameter& parameter : simulation.parameters()) {
    const auto found = lines.find("set." + parameter.name);
    if (found == lines.end()) {
      refuse(path, "its " + parameter.name + " is missing, and it must be " + parameter.allowed());
    }
    try {
      parameter.set(found->second);
    } catch (const BadInput& error) {
      refuse(path, error.what());
    }
  }
  if (!lines.count("method")) {
    refuse(path, "its method is missing, and it must be " + names_of(simulation.methods()));
  }

  using Of = Simulation;
  const double dt = number_of(path, lines, "dt", Of::valid_dt);
  Simulation::Memory memory{{number_of(path, lines, "time", Of::valid_time), dt,
                             number_of(path, lines, "grid_start", Of::valid_time),
                             number_of(path, lines, "into_step", {0, dt}),
                             count_of(path, lines, "grid_steps"), count_of(path, lines, "steps")},
                            number_of(path, lines, "tolerance", Of::valid_tolerance),
                            numbers_from(path, lines, body)};
  try {
    simulation.use_method(find_method(lines.at("method"), simulation.methods()));
    simulation.recall(memory);
  } catch (const BadInput& error) {
    refuse(path, error.what());
  }
}

}  // namespace bounce
