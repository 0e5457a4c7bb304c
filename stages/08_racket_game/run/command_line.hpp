#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "08_racket_game/game/game_run.hpp"
#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/run/bare_racket.hpp"
#include "run/options.hpp"

namespace bounce {

/// `--record-input`: the inputs of the last round, and where they are to be written (empty:
/// nowhere).
struct InputRecord {
  std::shared_ptr<InputLog> log = std::make_shared<InputLog>();
  std::string path;
};

/// `--player`. For `none` the bare physics takes the place of the game.
inline void choose_player(std::unique_ptr<Simulation>& simulation, const std::string& name) {
  const auto found = std::find(player_names.begin(), player_names.end(), name);
  if (found == player_names.end()) {
    throw BadInput("--player '" + name + "' is not allowed" + did_you_mean(name, player_names) +
                   ": it must be " + join(player_names, " or "));
  }
  if (name == "none") {
    simulation = std::make_unique<BareRacketRun>();
    return;
  }
  auto game = std::make_unique<GameRun>();
  game->play_as(static_cast<PlayerKind>(found - player_names.begin()));
  simulation = std::move(game);
}

inline GameRun& game_for(const std::string& option, Simulation& simulation) {
  if (GameRun* game = run_if<GameRun>(simulation)) return *game;
  throw BadInput(option + " is not allowed with --player none: only the game has inputs");
}

/// What this stage's command line has besides that of all stages. The answers go into `is_game`,
/// `asked` and `keys`, which must live as long as the options.
inline std::vector<StageOption> racket_game_options(bool& is_game, InputRecord& asked,
                                                    std::string& keys) {
  using SimulationPtr = std::unique_ptr<Simulation>;
  StageOption player{"--player", "NAME",
                     "human, autopilot, blind, idle, or none: the bare physics of ball and racket",
                     [&is_game](SimulationPtr& simulation, const std::string& name) {
                       choose_player(simulation, name);
                       is_game = name != "none";
                     }};
  player.is_saved = true;
  const auto record = [&asked](SimulationPtr& simulation, const std::string& path) {
    GameRun& game = game_for("--record-input", *simulation);
    OutputFile::check("--record-input", path);
    asked.path = path;
    game.record(asked.log);
  };
  const auto replay = [](SimulationPtr& simulation, const std::string& path) {
    GameRun& game = game_for("--replay", *simulation);
    game.replay(std::make_shared<const InputLog>(read_input_log(path)));
  };
  const auto other_keys = [&keys](SimulationPtr& simulation, const std::string& path) {
    game_for("--keys", *simulation);
    InputFile(std::string("--keys"), path);  // can it be read? Its lines are a window's
    keys = path;
  };
  StageOption recorded{"--record-input", "FILE",
                       "write the last round's inputs when the program ends", with_files(record)};
  StageOption replayed{"--replay", "FILE", "play recorded inputs in place of a player",
                       with_files(replay)};
  recorded.from_the_start = replayed.from_the_start = true;
  return {player,
          {"--keys", "FILE", "other keys, a line for each: 'J = A' lets J do what A does",
           with_files(other_keys)},
          recorded,
          replayed};
}

}  // namespace bounce
