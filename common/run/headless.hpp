#pragma once
#include <functional>

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

}  // namespace bounce
