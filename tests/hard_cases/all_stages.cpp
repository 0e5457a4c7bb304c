#include "all_stages.hpp"

#include <sstream>

#include "05_ball_collision/run/command_line.hpp"
#include "08_racket_game/run/command_line.hpp"
#include "stages/scene_simulations.hpp"

namespace bounce::test {
namespace {

template <class Run>
std::unique_ptr<Simulation> one() {
  return std::make_unique<Run>();
}

}  // namespace

const std::vector<Stage>& all_stages() {
  static bool is_game = true;
  static InputRecord record;
  static std::string keys;
  static const std::vector<Stage> all{
      {{"01_free_fall", ""}, one<OneBallRun<FreeFall, FreeFallExact>>},
      {{"02_spring_floor", ""}, one<OneBallRun<SpringFloor, SpringFloorExact>>},
      {{"03_damping", ""}, one<OneBallRun<Damping, DampingExact>>},
      {{"04_three_dimensions", ""}, one<OneBallRun<ThreeDimensions, ThreeDimensionsExact>>},
      {{"05_ball_collision", ""}, one<BallsRun>, ball_collision_options()},
      {{"06_oscillating_floor", ""},
       one<OneBallRun<OscillatingFloor, OscillatingFloorExact>>,
       {{"--sweep", "NAME=FROM,TO,N", "read by the program itself", {}, {}, {}}}},
      {{"07_tilted_plane", ""}, one<OneBallRun<TiltedPlane, TiltedPlaneExact>>},
      {{"08_racket_game", ""}, one<GameRun>, racket_game_options(is_game, record, keys)}};
  return all;
}

std::unique_ptr<Simulation> set_up(const Stage& stage, const std::string& command_line,
                                   Options& options) {
  std::vector<std::string> words{stage.name.name};
  std::istringstream text(command_line);
  for (std::string word; text >> word;) words.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  std::unique_ptr<Simulation> simulation = stage.make();
  parse_command_line(static_cast<int>(argv.size()), argv.data(), stage.name, simulation, options,
                     stage.options);
  return simulation;
}

}  // namespace bounce::test
