// What a run's settings look like as text: the table of --list, and the command that starts it.
#include <algorithm>
#include <array>

#include "run/options.hpp"

namespace bounce {

std::string list_text(const StageName& stage, Simulation& fresh) {
  std::string text = stage.name + ": " + stage.about +
                     "\n\nmethods: " + join(names_of(fresh.methods())) +
                     " (default: " + name_of(fresh.method()) + ")\n\n";
  using Row = std::array<std::string, 5>;
  std::vector<Row> rows{{"parameter", "unit", "default", "valid", "meaning"}};
  for (const Parameter& parameter : fresh.parameters()) {
    rows.push_back(
        {parameter.name, parameter.unit, parameter.text(), parameter.allowed(), parameter.meaning});
  }
  std::array<std::size_t, 4> widths{10, 6, 8, 32};  // wider where a word needs it
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text += row[i] + std::string(widths[i] - row[i].size() + 1, ' ');
    }
    text += row.back() + "\n";
  }
  return text;
}

std::string command_for(const StageName& stage, Simulation& now, Simulation& fresh) {
  std::string command = stage.name;
  if (now.method() != fresh.method()) command += " --method " + name_of(now.method());
  if (now.dt() != fresh.dt()) command += " --dt " + to_text(now.dt());
  if (now.tolerance() != fresh.tolerance()) {
    command += " --tolerance " + to_text(now.tolerance());
  }
  const std::unique_ptr<Simulation> standard = fresh.clone();  // what follows from the choices
  const std::vector<Parameter> values = now.parameters(), defaults = standard->parameters();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].text() == defaults[i].text()) continue;
    command += " --set " + values[i].name + "=" + values[i].text();
    if (values[i].chooses_defaults) defaults[i].set(values[i].text());
  }
  return command + now.traits().command;
}

}  // namespace bounce
