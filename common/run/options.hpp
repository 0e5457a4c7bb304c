#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "run/simulation.hpp"

namespace bounce {

/// A stage's name on the command line ("03_damping") and what it is about, in one line.
struct StageName {
  std::string name;
  std::string about;
};

/// Work on files, for an option of a stage or at a demo's end. A web page has no files: there it is
/// left out, and with it all the code that reads and writes them.
#ifdef __EMSCRIPTEN__
template <class Work>
std::nullptr_t with_files(const Work&) {
  return nullptr;
}
#else
template <class Work>
Work with_files(Work work) {
  return work;
}
#endif

/// An option that one stage has besides those that all have.
struct StageOption {
  std::string name;     // "--balls"
  std::string value;    // what follows it, for --help: "FILE"
  std::string meaning;  // one line, for --help
  /// Called with the text, before the parameters are set; throws BadInput. It may put another
  /// simulation in the place of this one. May be empty.
  std::function<void(std::unique_ptr<Simulation>&, const std::string& text)> apply = {};
  std::vector<std::string> replaces = {};  // parameters that cannot be set beside it
  /// Called when all is set and the run stands at its start, for what goes on from somewhere else.
  std::function<void(Simulation&, const std::string& text)> go_on = {};
  bool is_saved = false;        // `--save` keeps it, and `--load` applies it
  bool from_the_start = false;  // what it is about begins at t = 0, and not at a `--load`
};

/// What the user asked for on the command line. Parameters, method and time step are not here: they
/// are already set in the simulation.
struct Options {
  double duration = 10;    // s
  double sample = 0;       // s between trace rows; 0: a row every step
  std::vector<double> at;  // the times of the trace rows, ascending; empty: see `sample`
  std::string csv, screenshot, record, save, load;  // paths; empty: not wanted
  bool headless = false;  // also when a file is asked for that needs no window
  bool calm = false;
  bool from_above = false;
  std::map<std::string, std::string> of_stage;  // the stage's own options that were given, as text
};

/// Reads the command line (one for all stages) and sets up `simulation`. Returns false when the
/// question was answered on standard output (`--list`, `--help`) and there is nothing to run.
/// Throws BadInput.
bool parse_command_line(int argc, const char* const* argv, const StageName& stage,
                        std::unique_ptr<Simulation>& simulation, Options& options,
                        const std::vector<StageOption>& of_stage = {});

/// What an option was given, as a number. Throws BadInput.
double option_number(const std::string& option, const std::string& text, Range valid,
                     const std::string& unit = "", bool is_whole = false);

/// What follows each --set: "mass=2". First those that choose the others' defaults, wherever they
/// stand. Throws BadInput.
void set_parameters(const std::vector<std::string>& settings, Simulation& simulation);

/// What `--list` prints: the methods, and every parameter with unit, default, valid values,
/// meaning.
std::string list_text(const StageName& stage, Simulation& fresh);

/// The command that starts a run like this one: only what differs from the defaults.
std::string command_for(const StageName& stage, Simulation& now, Simulation& fresh);

}  // namespace bounce
