// Command lines as no lesson has them, each run as a program of its own, with a time limit.
//
//   hostile_command_lines table             every parameter, option and file entry with every bad
//   value hostile_command_lines random [N [SEED]] N lines out of good and bad words
//
// What is tried comes from --help and --list's own tables, so that a new parameter or method is
// tried, too. Of each run it asks: an exit code of 0, 1, 2 or 3; an end within the time limit; no
// sanitizer report; no number in the trace that is none. Of bad input, besides: one sentence that
// names what was wrong, and nothing left in the folder. A line that fails is printed, to be tried
// again.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <random>
#include <sstream>
#include <thread>

#include "all_stages.hpp"
#include "child_process.hpp"

using namespace bounce;
using test::Child;

namespace {

// s, for runs that mostly take milliseconds. A run may be long by right (1e11 steps are allowed),
// but then it must end when it is interrupted.
constexpr double time_limit = 10;

const std::vector<std::string> bad_values{"abc", "",  "NaN",   "inf",    "-inf",
                                          "-1",  "0", "1e308", "1e-320", "1,2"};

/// One command line, and what the sentence must name when it is refused.
struct Line {
  std::string program;
  std::vector<std::string> words;
  std::vector<std::string> names = {};
  std::vector<test::InputFile> files = {};  // that stand beside the run's folder, in ../in

  std::string text() const {
    std::string all = program;
    for (const std::string& word : words) all += " '" + word + "'";
    for (const auto& [name, content] : files) all += "\n  with " + name + ":\n" + content;
    return all;
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// What is wrong with how it went; empty: nothing.
std::string complaint(const Line& line, const Child& run) {
  if (run.timed_out) return "an interrupt was not heard";
  if (run.interrupted && run.code == 130) return "";
  if (run.code < 0 || run.code > 3) return "exit code " + std::to_string(run.code);
  for (const std::string mark : {"runtime error", "Sanitizer"}) {
    if (contains(run.err, mark)) return "a sanitizer's report";
  }
  for (const std::string none : {",nan", ",-nan", ",inf", ",-inf"}) {
    if (contains(run.out, none)) return "a trace with a number that is none";
  }
  if (run.code != 2) return "";
  if (!run.left_behind.empty()) return "bad input left the file " + run.left_behind;
  if (!run.out.empty()) return "bad input, and yet an output";
  if (std::count(run.err.begin(), run.err.end(), '\n') != 1) return "not one sentence";
  for (const std::string& name : line.names) {
    if (!contains(run.err, name)) return "the sentence does not name " + name;
  }
  return "";
}

/// Runs all lines, two at a time. Returns how many went wrong.
int attack(const std::vector<Line>& lines) {
  std::atomic<std::size_t> next{0};
  std::atomic<int> wrong{0};
  std::array<std::atomic<int>, 4> ends{};
  std::mutex screen;
  const auto work = [&] {
    test::ChildFolder folder;
    for (std::size_t i = next++; i < lines.size(); i = next++) {
      const Line& line = lines[i];
      const Child run = folder.run(line.program, line.words, line.files, time_limit);
      if (run.code >= 0 && run.code <= 3) ++ends[static_cast<std::size_t>(run.code)];
      const std::string why = complaint(line, run);
      if (why.empty()) continue;
      ++wrong;
      const std::lock_guard<std::mutex> hold(screen);
      std::cout << why << ":\n  " << line.text() << "\n  " << run.err.substr(0, 2000) << "\n";
    }
  };
  std::thread other(work);
  work();
  other.join();
  std::cout << lines.size() << " command lines: " << wrong
            << " went wrong; exit codes 0, 1, 2, 3: ";
  for (const auto& count : ends) std::cout << count << " ";
  std::cout << "\n";
  return wrong;
}

// ---- What there is to be tried

struct Known {
  const test::Stage* stage;
  std::vector<std::string> options, flags, parameters, methods;
};

/// The options of a program, from its --help.
Known known_of(const test::Stage& stage) {
  Known known{&stage, {}, {}, {}, {}};
  test::ChildFolder folder;
  std::istringstream help(folder.run(stage.name.name, {"--help"}, {}, time_limit).out);
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

/// A short run without a window, but without what the line says itself.
std::vector<std::string> short_run(const std::string& but) {
  std::vector<std::string> words{"--headless"};
  if (but != "--duration") words.insert(words.end(), {"--duration", "0.05"});
  if (but != "--csv") words.insert(words.end(), {"--csv", "-"});
  if (but != "--sample" && but != "--at") words.insert(words.end(), {"--sample", "0.01"});
  return words;
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
    for (const std::string& value : bad_values) add(option, {option, value}, {option, value});
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

// ---- Files

/// FNV-1a, as in the last line of a saved state: so that it is not the checksum that is refused.
std::string with_checksum(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  std::ostringstream all;
  all << text << "checksum " << std::hex << hash << "\n";
  return all.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

/// The file again and again, each time with one entry ("name value", or one of its numbers)
/// replaced by a bad value, or gone.
std::vector<std::string> spoilt(const std::string& text, const std::vector<std::string>& values,
                                const std::string& only = "") {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<std::string> all;
  const auto put = [&](std::size_t at, const std::string& line, bool keep) {
    std::string changed;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i != at) changed += lines[i] + "\n";
      if (i == at && keep) changed += line + "\n";
    }
    all.push_back(changed);
  };
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t space = lines[i].find(' ');
    if (space == std::string::npos || lines[i].rfind(only, 0) != 0) continue;
    const std::string name = lines[i].substr(0, space + 1);
    const std::vector<std::string> numbers = split(lines[i].substr(space + 1));
    put(i, "", false);
    // Of a long list the first ones, and the last.
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      if (n >= 60 && n + 1 < numbers.size()) continue;
      for (const std::string& value : values) {
        std::vector<std::string> changed = numbers;
        changed[n] = value;
        put(i, name + join(changed, ","), true);
      }
    }
  }
  return all;
}

std::vector<Line> lines_about_files(const std::vector<Known>& all) {
  std::vector<Line> lines;
  test::ChildFolder folder;
  for (const Known& known : all) {
    const std::string& program = known.stage->name.name;
    for (const std::string& method : known.methods) {
      std::vector<std::string> words{"--headless", "--duration", "0.46", "--save",
                                     "state",      "--method",   method};
      if (program == "08_racket_game" && method == "exact")
        words.insert(words.end(), {"--player", "none"});
      folder.run(program, words, {}, time_limit);
      const std::string saved = folder.read("state");
      const std::size_t end = saved.find("checksum ");
      if (end == std::string::npos) continue;
      // Parameters and clock are read alike for all methods; what each remembers is its own.
      const std::string only = method == known.methods[0] ? "" : "numbers ";
      for (const std::string& text : spoilt(saved.substr(0, end), bad_values, only)) {
        lines.push_back({program,
                         {"--headless", "--load", "../in/state", "--duration", "0.5", "--csv", "-"},
                         {"--load"},
                         {{"state", with_checksum(text)}}});
      }
    }
  }
  folder.run("08_racket_game",
             {"--headless", "--duration", "0.2", "--player", "autopilot", "--record-input", "log"},
             {}, time_limit);
  for (const std::string& text : spoilt(folder.read("log"), bad_values)) {
    lines.push_back({"08_racket_game",
                     {"--headless", "--replay", "../in/log", "--duration", "0.2", "--csv", "-"},
                     {},
                     {{"log", text}}});
  }
  const std::vector<std::string> columns{"mass", "radius", "x", "y", "z", "vx", "vy", "vz"};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const std::string& value : bad_values) {
      std::vector<std::string> numbers{"1", "0.1", "0", "1", "0", "0", "0", "0"};
      numbers[i] = value;
      const std::string text =
          join(columns, ",") + "\n" + join(numbers, ",") + "\n1,0.1,0.15,1,0,0,0,0\n";
      lines.push_back({"05_ball_collision",
                       {"--headless", "--balls", "../in/balls", "--duration", "0.2", "--csv", "-"},
                       {"--balls", value == "1,2" ? "8 columns" : columns[i]},
                       {{"balls", text}}});
    }
  }
  return lines;
}

// ---- At random

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

}  // namespace

int main(int argc, char** argv) {
  // The game keeps a best score; what a sanitizer finds must not look like a full disk (1).
  const test::ChildFolder home;
  setenv("XDG_DATA_HOME", home.path().c_str(), 1);
  setenv("ASAN_OPTIONS", "exitcode=99", 1);
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<Known> all;
  for (const test::Stage& stage : test::all_stages()) all.push_back(known_of(stage));
  if (!words.empty() && words[0] == "table") {
    std::vector<Line> lines = lines_about_files(all);
    for (const Known& known : all) {
      const std::vector<Line> more = lines_about(known);
      lines.insert(lines.end(), more.begin(), more.end());
    }
    return attack(lines) == 0 ? 0 : 1;
  }
  if (!words.empty() && words[0] == "random") {
    const int count = words.size() > 1 ? std::atoi(words[1].c_str()) : 10000;
    const std::uint64_t seed = words.size() > 2 ? std::strtoull(words[2].c_str(), nullptr, 10) : 1;
    std::cout << count << " random command lines, seed " << seed << std::endl;
    return attack(random_lines(all, count, seed)) == 0 ? 0 : 1;
  }
  std::cerr << "usage: hostile_command_lines table | random [N [SEED]]\n";
  return 2;
}
