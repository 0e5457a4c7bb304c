#include "run/save_load.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "run/output_file.hpp"

namespace bounce {
namespace {

constexpr const char* first_line = "bounce state, version 1\n";

/// FNV-1a, 64 bit: enough to notice a damaged file.
std::string checksum(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  }
  std::ostringstream hex;
  hex << std::hex << hash;
  return hex.str();
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw BadInput("--load '" + path + "' is not allowed: " + why +
                 "; it must be a file that --save wrote for this stage");
}

/// "name value" lines, the parameters as "set.NAME value".
using Lines = std::map<std::string, std::string>;

double number_of(const std::string& path, const Lines& lines, const std::string& name) {
  const auto found = lines.find(name);
  const std::optional<double> value =
      found == lines.end() ? std::nullopt : parse_number(found->second);
  if (!value) refuse(path, "it has no number for '" + name + "'");
  return *value;
}

Lines read_lines(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) refuse(path, "it is no file that can be read");
  std::ifstream file(path, std::ios::binary);
  std::stringstream content;
  if (!file || !(content << file.rdbuf())) refuse(path, "it cannot be read");
  const std::string text = content.str();
  if (text.rfind(first_line, 0) != 0) refuse(path, "it does not begin as a saved state does");
  const std::size_t last = text.rfind("checksum ");
  if (last == std::string::npos ||
      text.substr(last) != "checksum " + checksum(text.substr(0, last)) + "\n") {
    refuse(path, "it is damaged (its checksum does not fit)");
  }
  Lines lines;
  std::istringstream body(text.substr(0, last));
  for (std::string line; std::getline(body, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos) lines[line.substr(0, space)] = line.substr(space + 1);
  }
  return lines;
}

}  // namespace

void save_state(const std::string& path, const StageName& stage, Simulation& simulation) {
  const Simulation::Memory memory = simulation.memory();
  std::string text = first_line;
  text += "stage " + stage.name + "\n";
  text += "method " + name_of(simulation.method()) + "\n";
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
  text += "numbers " + to_text(memory.numbers) + "\n";
  text += "checksum " + checksum(text) + "\n";

  OutputFile file("--save", path);
  file.write(text);
  file.finish();
}

void load_state(const std::string& path, const StageName& stage, Simulation& simulation) {
  const Lines lines = read_lines(path);
  if (!lines.count("stage") || lines.at("stage") != stage.name) {
    refuse(path, "it belongs to another stage");
  }
  for (const Parameter& parameter : simulation.parameters()) {
    const auto found = lines.find("set." + parameter.name);
    if (found == lines.end()) refuse(path, "it does not say '" + parameter.name + "'");
    parameter.set(found->second);
  }
  if (!lines.count("method") || !lines.count("numbers")) refuse(path, "it is not complete");

  Simulation::Memory memory{number_of(path, lines, "time"),
                            number_of(path, lines, "dt"),
                            number_of(path, lines, "tolerance"),
                            number_of(path, lines, "grid_start"),
                            number_of(path, lines, "into_step"),
                            static_cast<long long>(number_of(path, lines, "grid_steps")),
                            static_cast<long long>(number_of(path, lines, "steps")),
                            {}};
  for (const std::string& word : split(lines.at("numbers"))) {
    const std::optional<double> value = parse_number(word);
    if (!value) refuse(path, "its state is not all numbers");
    memory.numbers.push_back(*value);
  }
  try {
    simulation.use_method(find_method(lines.at("method"), simulation.methods()));
    simulation.recall(memory);
  } catch (const BadInput& error) {
    refuse(path, error.what());
  }
}

}  // namespace bounce
