#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "run/options.hpp"
#include "run/simulation.hpp"

namespace bounce::test {

/// A stage as its program has it, but without a window.
struct Stage {
  StageName name;
  std::function<std::unique_ptr<Simulation>()> make;
  std::vector<StageOption> options = {};
};

/// All eight, in order.
const std::vector<Stage>& all_stages();

/// Reads the command line "--method rk4 --set mass=2" (words are what spaces part) as the stage's
/// program does. Throws BadInput.
std::unique_ptr<Simulation> set_up(const Stage& stage, const std::string& command_line,
                                   Options& options);

}  // namespace bounce::test
