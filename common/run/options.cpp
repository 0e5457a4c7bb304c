#include "run/options.hpp"

#include <algorithm>
#include <iostream>
#include <optional>

#include "run/command_words.hpp"
#include "run/save_load.hpp"
#include "run/step_warning.hpp"

namespace bounce {
namespace {

constexpr double most_steps = 1e11;
constexpr double most_rows = 1e8;

void apply_stage_options(const std::vector<StageOption>& of_stage, const Words& words,
                         const Options& options, std::unique_ptr<Simulation>& simulation) {
  for (const StageOption& option : of_stage) {
    const auto given = options.of_stage.find(option.name);
    if (given == options.of_stage.end()) continue;
    const bool starts = option.go_on || option.from_the_start || !option.replaces.empty();
    if (!options.load.empty() && starts) {
      throw BadInput("--load brings its own state: leave out " + option.name);
    }
    for (const std::string& setting : words.set) {
      const std::string name = trimmed(setting.substr(0, setting.find('=')));
      const auto& replaced = option.replaces;
      if (std::find(replaced.begin(), replaced.end(), name) == replaced.end()) continue;
      throw BadInput(option.name + " takes the place of " + name + ": give one of them");
    }
    if (option.apply) option.apply(simulation, given->second);
  }
}

double step_from(const std::string& text, const Simulation& simulation) {
  if (text != "auto") {
    if (const auto value = parse_number_in(text, Simulation::valid_dt)) return *value;
    throw BadInput("--dt '" + text + "' is not allowed: it must be " +
                   number_in(Simulation::valid_dt, "s") + ", or auto");
  }
  const std::optional<ContactNumbers> contact = simulation.contact();
  return contact ? comfortable_step_of(simulation.method(), *contact) : simulation.dt();
}

void read_times(const Words& words, Options& options, double start) {
  if (words.duration)
    options.duration = option_number("--duration", *words.duration, {1e-15, 1e15}, "s");
  if (options.duration <= start) {
    throw BadInput("--duration " + to_text(options.duration) +
                   " is not allowed: the saved run stands at " + to_text(start) +
                   " s, and the duration counts from 0");
  }
  if (words.sample) options.sample = option_number("--sample", *words.sample, {1e-15, 1e15}, "s");
  if (words.at) {
    if (options.sample > 0)
      throw BadInput("--at and --sample exclude each other: give one of them");
    const std::vector<std::string> times = split(*words.at);
    for (const std::string& text : times) {
      // 0.1 + 0.2 is one rounding beyond 0.3, and at the end all the same.
      const double asked = parse_number(text).value_or(0);
      if (asked <= options.duration * (1 + 1e-15)) {
        options.duration = std::max(options.duration, asked);
      }
      options.at.push_back(
          option_number("--at", text, {start, options.duration}, "s, the --duration"));
    }
    if (times.size() == 2 && words.at->find('.') == std::string::npos) {  // a comma decimal?
      std::cerr << "--at " << *words.at << " is two times, " << times[0] << " s and " << times[1]
                << " s; a decimal has a point, as in 0.5\n";
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

double option_number(const std::string& option, const std::string& text, Range valid,
                     const std::string& unit, bool is_whole) {
  if (const auto value = parse_number_in(text, valid, is_whole)) return *value;
  throw BadInput(option + " '" + text + "' is not allowed: it must be " +
                 number_in(valid, unit, is_whole));
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
      const Parameter& parameter = find_parameter(parameters, trimmed(setting.substr(0, equals)));
      if (parameter.chooses_defaults == chooses_defaults) {
        parameter.set(trimmed(setting.substr(equals + 1)));
      }
    }
  }
}

bool parse_command_line(int argc, const char* const* argv, const StageName& stage,
                        std::unique_ptr<Simulation>& chosen, Options& options,
                        const std::vector<StageOption>& of_stage) {
  Words words;
  if (!read_words(argc, argv, stage, of_stage, words, options)) return false;
  if (words.list) {
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
  if (words.seed) {
    const double seed = option_number("--seed", *words.seed, {0, 1e15}, "", true);
    chosen->use_seed(static_cast<std::uint64_t>(seed));
  }
  set_parameters(words.set, *chosen);
  if (words.method) chosen->use_method(find_method(*words.method, chosen->methods()));
  if (words.dt) chosen->use_dt(step_from(*words.dt, *chosen));
  if (words.tolerance) {
    chosen->use_tolerance(
        option_number("--tolerance", *words.tolerance, Simulation::valid_tolerance));
  }
  chosen->restart();
  if (!options.load.empty()) load_state(options.load, stage, of_stage, chosen);
  Simulation& simulation = *chosen;
  for (const StageOption& option : of_stage) {
    const auto given = options.of_stage.find(option.name);
    if (given != options.of_stage.end() && option.go_on) option.go_on(simulation, given->second);
  }
  if (const std::string why = simulation.traits().refusal; !why.empty()) throw BadInput(why);
  read_times(words, options, simulation.time());
  check_size(options, simulation);
  options.headless |= !options.csv.empty() || !options.screenshot.empty() ||
                      !options.record.empty() || words.at || options.sample > 0;
  return true;
}

}  // namespace bounce
