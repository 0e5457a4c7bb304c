#pragma once
#include <memory>
#include <string>
#include <vector>

#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/run/racket_run.hpp"
#include "run/options.hpp"

namespace bounce {

/// `--record-input`: the inputs of the last round, and where they are to be written (empty:
/// nowhere).
struct InputRecord {
  std::shared_ptr<InputLog> log = std::make_shared<InputLog>();
  std::string path;
};

inline void choose_player(RacketRun& run, const std::string& name) {
  static const std::vector<std::string> names{"human", "autopilot", "blind", "idle", "none"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return run.play_as(static_cast<PlayerKind>(i));
  }
  throw BadInput("--player '" + name + "' is not allowed" + did_you_mean(name, names) +
                 ": it must be " + join(names, " or "));
}

/// What this stage's command line has besides that of all stages. The answers go into `is_game`
/// and `asked`, which must live as long as the options.
inline std::vector<StageOption> racket_game_options(bool& is_game, InputRecord& asked) {
  const auto run_of = [](Simulation& simulation) -> RacketRun& {
    return static_cast<RacketRun&>(simulation);
  };
  const auto player = [=, &is_game](Simulation& simulation, const std::string& name) {
    choose_player(run_of(simulation), name);
    is_game = run_of(simulation).is_game();
  };
  const auto record = [=, &asked](Simulation& simulation, const std::string& path) {
    OutputFile::check("--record-input", path);
    asked.path = path;
    run_of(simulation).record(asked.log);
  };
  const auto replay = [=](Simulation& simulation, const std::string& path) {
    run_of(simulation).replay(std::make_shared<const InputLog>(read_input_log(path)));
  };
  return {{"--player", "NAME",
           "human, autopilot, blind, idle, or none: the bare physics of ball and racket", player},
          {"--record-input", "FILE", "write the last round's inputs when the program ends", record},
          {"--replay", "FILE", "play recorded inputs in place of a player", replay}};
}

}  // namespace bounce
