#pragma once
#include <functional>
#include <string>

#include "run/options.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Exit codes of every program (docs/README.md).
enum ExitCode {
  exit_ok = 0,
  exit_machine = 1,
  exit_input = 2,
  exit_physics = 3,
  exit_interrupted = 130
};

/// Runs to the end of the duration without a window: trace, saved state, one summary line on
/// standard error. Throws BadInput, MachineFailure, and what Simulation::advance_to throws.
/// Returns an ExitCode.
int run_headless(const StageName& stage, Simulation& simulation, const Options& options);

/// Calls `work` and turns what it throws into a sentence on standard error and an exit code.
int guarded(const StageName& stage, const Simulation& simulation, const std::function<int()>& work);

/// The largest step [s] that sees a swinging floor: a quarter of its swing. With longer ones it
/// would be another, slower floor, as a wheel in a film turns backwards. Infinity where nothing
/// swings.
double longest_seeing_step(const Simulation& simulation);

/// One sentence when the time step is too large for the contact, with the step that would do; else
/// empty.
std::string step_warning(const Simulation& simulation);

}  // namespace bounce
