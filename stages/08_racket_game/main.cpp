#include "08_racket_game/picture/game_view.hpp"
#include "08_racket_game/picture/hands.hpp"
#include "08_racket_game/run/command_line.hpp"
#include "app/demo.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo;
  InputRecord record;
  demo.stage = {"08_racket_game", "keep a falling ball in the air with a disc racket"};
  demo.title = "Stage 8: the racket game";
  demo.question =
      "The bare physics of ball and racket. Where must the ball meet the disc, and how must the "
      "disc lean, for the ball to come back?";
  demo.sliders = {"racket_normal", "damping"};
  demo.make = [] { return std::make_unique<GameRun>(); };
  demo.bare = true;  // a game has no panel; the bare physics, which an option asks for, has one
  demo.options = racket_game_options(demo.bare, record, demo.keys);
  demo.plots = {plot_column("velocity along y (up)", "m/s", "vy")};
  if constexpr (has_picture) use_hands(demo, use_game_view(demo));
  demo.at_end = with_files([&record] {
    if (!record.path.empty()) write_input_log(record.path, *record.log);
  });
  return play(argc, argv, demo);
}
