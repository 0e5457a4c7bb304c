#include "hostile_lines.hpp"

#include <algorithm>
#include <cctype>
#include <random>
#include <sstream>

namespace bounce::test {
namespace {

/// A short run without a window, but without what the line says itself.
std::vector<std::string> short_run(const std::string& but) {
  std::vector<std::string> words{"--headless"};
  if (but != "--duration") words.insert(words.end(), {"--duration", "0.05"});
  if (but != "--csv") words.insert(words.end(), {"--csv", "-"});
  if (but != "--sample" && but != "--at") words.insert(words.end(), {"--sample", "0.01"});
  return words;
}

}  // namespace

std::string Line::text() const {
  std::string all = program;
  for (const std::string& word : words) all += " '" + word + "'";
  for (const auto& [name, content] : files) all += "\n  with " + name + ":\n" + content;
  return all;
}

Known known_of(const Stage& stage) {
  Known known{&stage, {}, {}, {}, {}};
  ChildFolder folder;
  std::istringstream help(folder.run(stage.name.name, {"--help"}, {}, 60).out);
  for (std::string line; std::getline(help, line);) {
    const std::size_t dashes = line.find("--");
    if (dashes == std::string::npos || dashes > 6 || line.find_first_not_of(' ') > 4) continue;
    std::istringstream words(line.substr(dashes));
    std::string name, value;
    words >> name >> value;
    const bool takes_value = !value.empty() && std::isupper(static_cast<unsigned char>(value[0]));
    (takes_value ? known.options : known.flags).push_back(name);
  }
  const std::unique_ptr<Simulation> simulation = stage.make();
  for (const Parameter& parameter : simulation->parameters()) {
    known.parameters.push_back(parameter.name);
  }
  for (const Method method : simulation->methods()) known.methods.push_back(name_of(method));
  return known;
}

std::vector<Line> lines_about(const Known& known) {
  const std::string& program = known.stage->name.name;
  std::vector<Line> lines;
  const auto add = [&](const std::string& about, std::vector<std::string> words,
                       std::vector<std::string> names) {
    std::vector<std::string> all = short_run(about);
    all.insert(all.end(), words.begin(), words.end());
    lines.push_back({program, all, std::move(names)});
  };
  for (const std::string& name : known.parameters) {
    add("", {"--set", name}, {"--set", name});
    for (const std::string& value : bad_values) {
      for (const std::string& method : known.methods) {
        std::vector<std::string> words{"--set", name + "=" + value, "--method", method};
        if (program == "08_racket_game") words.insert(words.end(), {"--player", "none"});
        add("", words, {name, value});
      }
    }
  }
  for (const std::string& option : known.options) {
    add(option, {option}, {option});
    add(option, {option + "=", "--calm"}, {option});
    for (const std::string& value : bad_values) {
      // --at takes several values, and names the one that is wrong.
      add(option, {option, value}, {option, option == "--at" && value == "1,2" ? "1" : value});
    }
    add(option, {option, "1", option, "2"},
        option == "--set" ? std::vector<std::string>{} : std::vector{option});
  }
  for (const std::string& flag : known.flags) {
    if (flag == "--help" || flag == "--list") continue;
    for (const std::string& value : bad_values) add(flag, {flag + "=" + value}, {flag});
  }
  // More steps or rows than are allowed.
  add("--duration", {"--dt", "1e-12", "--duration", "1"}, {"--dt", "1e-12", "1e11"});
  lines.push_back(
      {program, {"--headless", "--csv", "-", "--dt", "1e-8", "--duration", "2"}, {"--csv", "1e8"}});
  lines.push_back({program, {"--headless", "--csv", "-", "--sample", "1e-9"}, {"--csv", "1e8"}});
  return lines;
}

std::vector<Line> random_lines(const std::vector<Known>& all, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto one_of = [&](const std::vector<std::string>& words) {
    return words[random() % words.size()];
  };
  const auto chance = [&](unsigned percent) { return random() % 100 < percent; };
  const std::vector<std::string> good{
      "1",  "0.5", "2",         "0.001", "1e-4", "10",   "0,1,0", "1,2,3", "0,0",  "auto",
      "on", "off", "push-only", "drop",  "1e15", "1e30", "1e-30", "1e9",   "1e-12"};
  const std::vector<std::string> junk{"",         "-",     "--",       "---",          "=",
                                      "--set=",   "-x",    "\xff\xfe", "--csv=",       "nan",
                                      "--dt=nan", "%s%n",  "../..",    "/dev/full",    "/dev/null",
                                      "0x1p3",    "1e999", "1,,2",     "--headless=2", "--at=1,2"};
  const auto value = [&] {
    return chance(60) ? one_of(good) : chance(80) ? one_of(bad_values) : one_of(junk);
  };
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const Known& known = all[random() % all.size()];
    std::vector<std::string> words{"--headless"};
    if (chance(80))
      words.insert(words.end(), {"--duration", one_of({"0.01", "0.02", "0.05", "0.3"})});
    if (chance(60)) words.insert(words.end(), {"--method", one_of(known.methods)});
    if (chance(40)) words.insert(words.end(), {"--csv", one_of({"-", "out.csv", "-"})});
    if (known.stage->name.name == "08_racket_game" && chance(60)) {
      words.insert(words.end(),
                   {"--player", one_of({"none", "none", "autopilot", "blind", "idle", "human"})});
    }
    while (chance(65))
      words.insert(words.end(), {"--set", one_of(known.parameters) + "=" + value()});
    while (chance(25)) {
      const std::string option = one_of(known.options);
      if (option == "--record") continue;  // a clip takes seconds
      words.push_back(option);
      if (chance(95)) words.push_back(value());
    }
    while (chance(10)) words.push_back(chance(50) ? one_of(known.flags) : one_of(junk));
    if (chance(5)) words.erase(words.begin() + static_cast<std::ptrdiff_t>(1 % words.size()));
    lines.push_back({known.stage->name.name, words});
  }
  return lines;
}

std::string complaint_about_sentence(const Line& line, const std::string& sentence) {
  const auto contains = [&](const std::string& part) {
    return sentence.find(part) != std::string::npos;
  };
  if (std::count(sentence.begin(), sentence.end(), '\n') != 1) return "not one sentence";
  for (const std::string& name : line.names) {
    if (!contains(name)) return "the sentence does not name " + name;
  }
  const std::vector<std::string> allowing{"must", "at most", "are allowed", "takes one value"};
  if (!line.names.empty() && std::none_of(allowing.begin(), allowing.end(), contains)) {
    return "the sentence does not say what is allowed";
  }
  return "";
}

}  // namespace bounce::test
