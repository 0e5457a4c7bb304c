#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/options.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Writes parameters, method, clock and state as readable text, in decimals that read back to the
/// same bits (the numbers of many balls raw): a run that goes on from the file gives what it would
/// have given without the stop.
void save_state(const std::string& path, const StageName& stage, Simulation& simulation);

/// Sets the simulation to what the file says; before that it applies what the file has of the
/// stage's own options (StageOption::is_saved), which may put another simulation in its place.
/// Throws BadInput when the file cannot be read, is damaged (its checksum fails), belongs to
/// another stage, or was written by a newer program.
void load_state(const std::string& path, const StageName& stage,
                const std::vector<StageOption>& of_stage, std::unique_ptr<Simulation>& simulation);

}  // namespace bounce
