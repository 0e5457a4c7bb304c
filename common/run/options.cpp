#include "run/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include "physics/stability.hpp"
#include "run/headless.hpp"
#include "run/output_file.hpp"
#include "run/save_load.hpp"

namespace bounce {
namespace {

constexpr double most_steps = 1e11;
constexpr double most_rows = 1e8;

double number(const std::string& option, const std::string& text, Range valid, const char* unit) {
  const std::optional<double> value = parse_number(text);
  if (value && valid.contains(*value)) return *value;
  throw BadInput(option + " '" + text + "' is not allowed: it must be a number from " +
                 to_text(valid.lowest) + " to " + to_text(valid.highest) + unit);
}

/// The words of the command line as they came; checked later, so that all messages are ours.
struct Words {
  std::optional<std::string> method, dt, duration, tolerance, sample, at, seed;
  std::vector<std::string> set;
};

void declare(CLI::App& app, Words& words, Options& options, bool& list) {
  app.set_help_flag("-h,--help", "this page");
  app.add_option("--method", words.method, "how time is moved; --list names the methods")
      ->type_name("NAME");
  app.add_option("--dt", words.dt,
                 "time step (default 0.001); auto: a twentieth of the largest stable step of the "
                 "slides' loop, or less for a restitution right to 0.01")
      ->type_name("S|auto");
  app.add_option("--tolerance", words.tolerance, "error control of the method 'reference'")
      ->type_name("T");
  app.add_option("--duration", words.duration, "simulated seconds (default 10)")->type_name("S");
  app.add_option("--set", words.set, "set a parameter; may be given more than once")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--list", list, "show methods and parameters, with units and valid values");
  app.add_flag("--headless", options.headless, "run without a window, as fast as possible");
  app.add_option("--csv", options.csv, "write the trace; '-' is standard output (no window)")
      ->type_name("FILE|-");
  app.add_option("--sample", words.sample, "trace rows at 0, S, 2 S, ... instead of every step")
      ->type_name("S");
  app.add_option("--at", words.at, "trace rows at exactly these times")->type_name("T1,T2,...");
  app.add_option("--screenshot", options.screenshot,
                 "the picture at the end of --duration (no window)")
      ->type_name("FILE.png");
  app.add_option("--record", options.record, "a clip of --duration; needs ffmpeg (no window)")
      ->type_name("FILE.gif|FILE.mp4");
  app.add_option("--save", options.save, "save the state at the end of the run")->type_name("FILE");
  app.add_option("--load", options.load, "go on from a saved state")->type_name("FILE");
  app.add_option("--seed", words.seed, "for scenes with chance in them (default 1)")
      ->type_name("N");
  app.add_flag("--calm", options.calm, "no trail and nothing that flashes or shakes");
  app.allow_extras();  // to say ourselves what was not understood
}

/// The words in CLI11's order, from the last to the first. Two things that it does not see as we
/// do: "--csv=" without a value would take the next word for it, and "--at -inf" has a value,
/// though it looks like an option.
std::vector<std::string> tidy_words(int argc, const char* const* argv, const CLI::App& app) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word.size() > 3 && word.rfind("--", 0) == 0 && word.find('=') == word.size() - 1) {
      word.pop_back();
      throw BadInput(word + " '' is not allowed: after " + word + "= there must be a value");
    }
    const CLI::Option* option = word.rfind("--", 0) == 0 ? app.get_option_no_throw(word) : nullptr;
    const std::string next = i + 1 < argc ? argv[i + 1] : "";
    if (option != nullptr && option->get_expected_max() > 0 && next.size() > 1 && next[0] == '-' &&
        next[1] != '-' && next != "-h") {
      word += "=" + next;
      ++i;
    }
    words.insert(words.begin(), word);
  }
  return words;
}

/// Answers a question on standard output.
void answer(const std::string& option, const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw MachineFailure(option + " could not be written to standard output");
}

[[noreturn]] void refuse_extra(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  if (word.rfind("-", 0) != 0) {
    throw BadInput("'" + word + "' is not understood: options begin with --, such as --set " +
                   (word.find('=') == std::string::npos ? "NAME=VALUE" : word));
  }
  const std::string name = word.substr(0, word.find('='));
  throw BadInput("there is no option " + name + did_you_mean(name, known) +
                 ": --help shows all options");
}

void set_parameters(const std::vector<std::string>& settings, Simulation& simulation) {
  const std::vector<Parameter> parameters = simulation.parameters();
  // First those that choose the others' defaults, wherever they stand on the command line.
  for (const bool chooses_defaults : {true, false}) {
    for (const std::string& setting : settings) {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos) {
        throw BadInput("--set '" + setting +
                       "' is not allowed: it must be NAME=VALUE, such as --set " +
                       parameters[0].name + "=" + parameters[0].text());
      }
      const Parameter& parameter = find_parameter(parameters, setting.substr(0, equals));
      if (parameter.chooses_defaults == chooses_defaults) {
        parameter.set(setting.substr(equals + 1));
      }
    }
  }
}

void apply_stage_options(const std::vector<StageOption>& of_stage, const Words& words,
                         const Options& options, std::unique_ptr<Simulation>& simulation) {
  for (const StageOption& option : of_stage) {
    const auto given = options.of_stage.find(option.name);
    if (given == options.of_stage.end() || !option.apply) continue;
    if (!options.load.empty() && !option.replaces.empty()) {
      throw BadInput("--load brings its own state: leave out " + option.name);
    }
    for (const std::string& setting : words.set) {
      const std::string name = setting.substr(0, setting.find('='));
      const auto& replaced = option.replaces;
      if (std::find(replaced.begin(), replaced.end(), name) == replaced.end()) continue;
      throw BadInput(option.name + " takes the place of " + name + ": give one of them");
    }
    option.apply(simulation, given->second);
  }
}

std::uint64_t seed_from(const std::string& text) {
  const double seed = number("--seed", text, {0, 1e15}, "");
  if (seed == std::floor(seed)) return static_cast<std::uint64_t>(seed);
  throw BadInput("--seed '" + text + "' is not allowed: it must be a whole number");
}

double step_from(const std::string& text, const Simulation& simulation) {
  if (text != "auto") {
    const std::optional<double> value = parse_number(text);
    if (value && *value >= 1e-15 && *value <= 1e15) return *value;
    throw BadInput("--dt '" + text +
                   "' is not allowed: it must be a number from 1e-15 to 1e15 (s), or auto");
  }
  const std::optional<ContactNumbers> contact = simulation.contact();
  return contact ? comfortable_step(contact->omega0, contact->zeta) : simulation.dt();
}

void read_times(const Words& words, Options& options, double start) {
  if (words.duration)
    options.duration = number("--duration", *words.duration, {1e-15, 1e15}, " (s)");
  if (options.duration <= start) {
    throw BadInput("--duration " + to_text(options.duration) +
                   " is not allowed: the saved run stands at " + to_text(start) +
                   " s, and the duration counts from 0");
  }
  if (words.sample) options.sample = number("--sample", *words.sample, {1e-15, 1e15}, " (s)");
  if (words.at) {
    if (options.sample > 0)
      throw BadInput("--at and --sample exclude each other: give one of them");
    for (const std::string& text : split(*words.at)) {
      options.at.push_back(number("--at", text, {start, options.duration}, " (s, the --duration)"));
    }
    std::sort(options.at.begin(), options.at.end());
  }
}

void check_size(const Options& options, const Simulation& simulation) {
  const bool stepping = !simulation.method().goes_by_events;
  const double steps = options.duration / simulation.dt();
  if (stepping && steps > most_steps) {
    throw BadInput("--dt " + to_text(simulation.dt()) + " with --duration " +
                   to_text(options.duration) + " is not allowed: that is " +
                   to_rounded_text(steps) + " steps, and a run may have at most 1e11");
  }
  if (const double seeing = longest_seeing_step(simulation); simulation.dt() > seeing) {
    throw BadInput("--dt " + to_text(simulation.dt()) +
                   " with angular_frequency = " + to_text(simulation.traits().swing_rate) +
                   " is not allowed: a step would not see the floor swing, it must be at most " +
                   to_rounded_text(seeing) + " s (a quarter of a swing)");
  }
  if (options.csv.empty()) return;
  const double rows = !options.at.empty()  ? static_cast<double>(options.at.size())
                      : options.sample > 0 ? options.duration / options.sample
                      : stepping           ? steps
                                           : 0;
  const double in_all = rows * static_cast<double>(simulation.balls());
  if (in_all > most_rows) {
    throw BadInput("--csv would get " + to_rounded_text(in_all) +
                   " rows, and at most 1e8 are allowed: give a longer --sample or some --at times");
  }
}

}  // namespace

void apply_saved_options(const std::string& path, const std::vector<StageOption>& of_stage,
                         std::unique_ptr<Simulation>& simulation) {
  for (const auto& [name, value] : saved_options(path)) {
    for (const StageOption& option : of_stage) {
      if (!option.is_saved || option.name != "--" + name) continue;
      try {
        option.apply(simulation, value);
      } catch (const BadInput& error) {
        throw BadInput("--load '" + path + "' is not allowed: it was saved with " + error.what());
      }
    }
  }
}

bool parse_command_line(int argc, const char* const* argv, const StageName& stage,
                        std::unique_ptr<Simulation>& chosen, Options& options,
                        const std::vector<StageOption>& of_stage) {
  CLI::App app(stage.about, stage.name);
  Words words;
  bool list = false;
  declare(app, words, options, list);
  for (const StageOption& option : of_stage) {
    const auto keep = [&options, name = option.name](const std::string& text) {
      options.of_stage[name] = text;
    };
    app.add_option_function<std::string>(option.name, keep, option.meaning)
        ->type_name(option.value);
  }
  try {
    app.parse(tidy_words(argc, argv, app));
  } catch (const CLI::CallForHelp&) {
    answer("--help", app.help());
    return false;
  } catch (const CLI::ParseError& error) {
    // "--dt: 1 required S|auto missing" and the like
    throw BadInput(std::string(error.what()) +
                   ": an option takes one value; --help shows them all");
  }
  if (!app.remaining().empty()) refuse_extra(app, app.remaining().front());

  for (const char* option : {"--csv", "--screenshot", "--record", "--save", "--load"}) {
    if (app.count(option) > 0 && app[option]->as<std::string>().empty()) {
      throw BadInput(std::string(option) + " '' is not allowed: it must be the path of a file");
    }
  }
  if (list) {
    answer("--list", list_text(stage, *chosen));
    return false;
  }
  const bool sets = words.method || words.dt || words.tolerance || !words.set.empty();
  if (!options.load.empty() && sets) {
    throw BadInput(
        "--load brings its own method, time step and parameters: leave out --method, "
        "--dt, --tolerance and --set");
  }
  apply_stage_options(of_stage, words, options, chosen);
  if (!options.load.empty()) apply_saved_options(options.load, of_stage, chosen);
  Simulation& simulation = *chosen;
  if (words.seed) options.seed = seed_from(*words.seed);
  simulation.use_seed(options.seed);
  set_parameters(words.set, simulation);
  if (words.method) {
    simulation.use_method(find_method(*words.method, simulation.methods()));
  }
  if (words.dt) simulation.use_dt(step_from(*words.dt, simulation));
  if (words.tolerance) {
    simulation.use_tolerance(number("--tolerance", *words.tolerance, {1e-15, 1}, ""));
  }
  simulation.restart();
  if (!options.load.empty()) {
    load_state(options.load, stage, simulation);
  }
  for (const StageOption& option : of_stage) {
    const auto given = options.of_stage.find(option.name);
    if (given == options.of_stage.end() || !option.go_on) continue;
    if (!options.load.empty())
      throw BadInput("--load brings its own state: leave out " + option.name);
    option.go_on(simulation, given->second);
  }
  if (const std::string why = simulation.traits().refusal; !why.empty()) throw BadInput(why);
  read_times(words, options, simulation.time());
  check_size(options, simulation);
  options.headless |= !options.csv.empty() || !options.screenshot.empty() ||
                      !options.record.empty() || words.at || options.sample > 0;
  return true;
}

std::string list_text(const StageName& stage, Simulation& fresh) {
  std::string text = stage.name + ": " + stage.about + "\n\nmethods: " + names_of(fresh.methods()) +
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
