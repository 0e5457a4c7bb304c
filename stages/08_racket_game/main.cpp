#include "app/demo.hpp"
#include "app/palette.hpp"
#include "game_view.hpp"
#include "hands.hpp"
#include "input_log.hpp"
#include "racket_run.hpp"

using namespace bounce;

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
  demo.bare = true;  // a game has no panel
  demo.title = "Stage 8: the racket game";
  demo.question =
      "The bare physics of ball and racket. Where must the ball meet the disc, and how must the "
      "disc "
      "lean, for the ball to come back?";
  demo.sliders = {"racket_normal", "damping"};
  demo.options = {{"--player", "NAME",
                   "human, autopilot, blind, idle, or none: the bare physics of ball and racket",
                   [&demo](Simulation& simulation, const std::string& name) {
                     choose_player(simulation, name);
                     demo.bare = static_cast<RacketRun&>(simulation).is_game();
                   }},
                  {"--record-input", "FILE", "write the last round's inputs when the program ends",
                   [log, &record_path](Simulation& simulation, const std::string& path) {
                     OutputFile::check("--record-input", path);
                     record_path = path;
                     static_cast<RacketRun&>(simulation).record(log);
                   }},
                  {"--replay", "FILE", "play recorded inputs in place of a player", replay}};
  demo.make = [] { return std::make_unique<RacketRun>(); };
  GameView view;
  Hands hands;
  demo.picture = [&](const Player& player, const View& seen, Canvas& canvas) {
    view.draw(canvas, player, seen, demo.bare);
  };
  demo.control = [&](Player& player, const View&, const Controls& controls) {
    view.is_live = true;
    hands(player, controls, view);
  };
  demo.knock = [](const Player& player) {
    const Round& round = static_cast<const RacketRun&>(player.simulation()).round();
    return Knock{round.touches, round.touch_speed};
  };
  demo.is_over = [](const Player& player) {  // a machine that has lost serves again
    const RacketRun& run = static_cast<const RacketRun&>(player.simulation());
    const Round& round = run.round();
    return round.score.lost && run.settings().player != PlayerKind::human &&
           round.clock - round.lost_clock > 2;
  };
  demo.plots = {{"velocity along y (up)", "m/s", palette::motion,
                 [](const TracePoint& point) { return point.values[4]; },
                 [](const TracePoint& point) { return point.exact[4]; }}};
  return guarded(demo.stage, RacketRun(), [&]() -> int {
    const int code = play(argc, argv, demo);
    if (code == exit_ok && !record_path.empty()) write_input_log(record_path, *log);
    return code;
  });
}
