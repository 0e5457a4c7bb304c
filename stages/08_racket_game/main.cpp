#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/space_view.hpp"
#include "racket_run.hpp"

using namespace bounce;

static BallInSpace ball(const Player& player) {
  const RacketRun& run = static_cast<const RacketRun&>(player.simulation());
  BallInSpace look;
  look.radius = run.settings().racket.radius;
  look.has_plane = false;
  look.forces = [](const State<Eigen::Vector3d>&) { return ForcesInSpace{}; };
  return look;
}

static void choose_player(Simulation& simulation, const std::string& name) {
  static const std::vector<std::string> names{"human", "autopilot", "blind", "idle", "none"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != name) continue;
    static_cast<RacketRun&>(simulation).play_as(static_cast<PlayerKind>(i));
    return;
  }
  throw BadInput("--player '" + name + "' is not allowed" + did_you_mean(name, names) +
                 ": it must be " + join(names, " or "));
}

static void replay(Simulation& simulation, const std::string& path) {
  static_cast<RacketRun&>(simulation)
      .replay(std::make_shared<const InputLog>(read_input_log(path)));
}

int main(int argc, char** argv) {
  Demo demo;
  const auto log = std::make_shared<InputLog>();
  std::string record_path;
  demo.stage = {"08_racket_game", "keep a falling ball in the air with a disc racket"};
  demo.title = "Stage 8: the racket game";
  demo.question = "Keep it up!";
  demo.sliders = {"assist"};
  demo.options = {{"--player", "NAME",
                   "human, autopilot, blind, idle, or none: the bare physics of ball and racket",
                   choose_player},
                  {"--record-input", "FILE", "write the last round's inputs when the program ends",
                   [log, &record_path](Simulation& simulation, const std::string& path) {
                     OutputFile::check("--record-input", path);
                     record_path = path;
                     static_cast<RacketRun&>(simulation).record(log);
                   }},
                  {"--replay", "FILE", "play recorded inputs in place of a player", replay}};
  demo.make = [] { return std::make_unique<RacketRun>(); };
  use_space_view(demo, ball);
  return guarded(demo.stage, RacketRun(), [&]() -> int {
    const int code = play(argc, argv, demo);
    if (code == exit_ok && !record_path.empty()) write_input_log(record_path, *log);
    return code;
  });
}
