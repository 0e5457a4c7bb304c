#include "run/save_load.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>
#include <type_traits>

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

/// Eight bytes a number, the lowest first on every machine.
void append_raw(std::string& text, const std::vector<double>& numbers) {
  text.reserve(text.size() + 8 * numbers.size() + 100);
  for (const double number : numbers) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);  // emscripten's library has no std::bit_cast yet
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

/// The number in the line of that name.
template <class Number>
void read(const InputFile& file, const Lines& lines, const std::string& name, Number& number,
          Range valid) {
  constexpr bool is_whole = std::is_integral_v<Number>;
  const auto found = lines.find(name);
  const bool is_there = found != lines.end();
  if (const auto value =
          is_there ? parse_number_in(found->second, valid, is_whole) : std::nullopt) {
    number = static_cast<Number>(*value);
  } else {
    file.refuse("its " + name + (is_there ? " is '" + found->second + "'" : " is missing") +
                ", and it must be " + number_in(valid, "", is_whole));
  }
}

std::string read_text(InputFile& file) {
  std::string text = file.whole();
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // some editors' mark
  // Another system's ends of lines. (Where numbers stand raw they would be damage, and stay so.)
  const std::size_t first_end = text.find('\n');
  if (first_end != text.npos && first_end > 0 && text[first_end - 1] == '\r') {
    std::erase(text, '\r');
  }
  return text;
}

/// What is between the first line and the checksum, if all is well.
std::string_view checked(const InputFile& file, std::string_view text) {
  const std::size_t first_end = text.find('\n');
  if (text.rfind(first_words, 0) != 0 || first_end == text.npos) {
    file.refuse("it does not begin as a saved state does");
  }
  const std::string its(text.substr(first_words.size(), first_end - first_words.size()));
  const std::optional<double> its_version = parse_number(its);
  if (!its_version || *its_version < 1) file.refuse("it has no version");
  if (*its_version > version) {
    file.refuse("a newer program wrote it (version " + its + "; this one knows up to " +
                std::to_string(version) + ")");
  }
  const std::size_t last = text.rfind("checksum ");
  if (last == text.npos ||
      text.substr(last) != "checksum " + checksum(text.substr(0, last)) + "\n") {
    file.refuse("it is damaged (its checksum does not fit)");
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
std::vector<double> numbers_from(const InputFile& file, const Lines& lines,
                                 std::string_view behind) {
  if (lines.count("raw")) {
    long long count = 0;
    read(file, lines, "raw", count, Simulation::valid_count);
    if (static_cast<double>(behind.size()) != 8 * static_cast<double>(count) + 1)
      file.refuse("it is not complete");
    return read_raw(behind.substr(0, behind.size() - 1));
  }
  if (!lines.count("numbers")) file.refuse("it is not complete: the state is missing");
  std::vector<double> numbers;
  for (const std::string& word : split(lines.at("numbers"))) {
    const std::optional<double> number = parse_number(word);
    if (!number) {
      file.refuse("its state's number " + std::to_string(numbers.size() + 1) + " is '" + word +
                  "', and it must be " + number_in(Simulation::valid_number));
    }
    numbers.push_back(*number);
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
  Simulation::Memory::each(memory, [&text](const std::string& name, auto value, Range) {
    if constexpr (std::is_integral_v<decltype(value)>) {
      text += name + " " + std::to_string(value) + "\n";
    } else {
      text += name + " " + to_text(value) + "\n";
    }
  });
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

void load_state(const std::string& path, const StageName& stage,
                const std::vector<StageOption>& of_stage, std::unique_ptr<Simulation>& chosen) {
  InputFile file("--load", path, "it must be a file that --save wrote for this stage");
  const std::string text = read_text(file);
  std::string_view body = checked(file, text);
  const Lines lines = take_lines(body);
  if (!lines.count("stage") || lines.at("stage") != stage.name) {
    const std::string its = lines.count("stage") ? "is '" + lines.at("stage") + "'" : "is missing";
    file.refuse("its stage " + its + ", and it must be '" + stage.name + "'");
  }
  for (const StageOption& option : of_stage) {
    const auto saved = lines.find("option." + option.name.substr(2));
    if (!option.is_saved || saved == lines.end()) continue;
    try {
      option.apply(chosen, saved->second);
    } catch (const BadInput& error) {
      file.refuse(std::string("it was saved with ") + error.what());
    }
  }
  Simulation::Memory memory;
  Simulation::Memory::each(memory, [&](const char* name, auto& value, Range valid) {
    read(file, lines, name, value, valid);
  });
  memory.numbers = numbers_from(file, lines, body);

  Simulation& simulation = *chosen;
  const auto text_of = [&lines](const char* kind, const std::string& name,
                                const std::string& allowed) {
    const auto found = lines.find(kind + name);
    if (found != lines.end()) return found->second;
    throw BadInput("its " + name + " is missing, and it must be " + allowed);
  };
  try {
    for (const Parameter& parameter : simulation.parameters()) {
      parameter.set(text_of("set.", parameter.name, parameter.allowed()));
    }
    const std::vector<Method> offered = simulation.methods();
    simulation.use_method(find_method(text_of("", "method", join(names_of(offered))), offered));
    simulation.recall(memory);
  } catch (const BadInput& error) {
    file.refuse(error.what());
  }
}

}  // namespace bounce
