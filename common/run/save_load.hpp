#pragma once
#include <map>
#include <string>

#include "run/options.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Writes parameters, method, clock and state as readable text, in decimals that read back to the
/// same bits (the numbers of many balls raw): a run that goes on from the file gives what it would
/// have given without the stop.
void save_state(const std::string& path, const StageName& stage, Simulation& simulation);

/// What a saved run has of the stage's own options (StageOption::is_saved), name by name. Throws
/// BadInput as load_state does.
std::map<std::string, std::string> saved_options(const std::string& path);

/// Sets the simulation to what the file says. Throws BadInput when the file cannot be read, is
/// damaged (its checksum fails), belongs to another stage, or was written by a newer program.
void load_state(const std::string& path, const StageName& stage, Simulation& simulation);

}  // namespace bounce
