#include "08_racket_game/picture/game_view.hpp"
#include "08_racket_game/picture/hands.hpp"
#include "08_racket_game/run/options.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo;
  InputRecord record;
  demo.stage = {"08_racket_game", "keep a falling ball in the air with a disc racket"};
  demo.bare = true;  // a game has no panel
  demo.title = "Stage 8: the racket game";
  demo.question =
      "The bare physics of ball and racket. Where must the ball meet the disc, and how must the "
      "disc "
      "lean, for the ball to come back?";
  demo.sliders = {"racket_normal", "damping"};
  demo.options = racket_game_options(demo.bare, record);
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
    if (code == exit_ok && !record.path.empty()) write_input_log(record.path, *record.log);
    return code;
  });
}
