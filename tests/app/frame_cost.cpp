// What a frame costs: processor time of physics and picture in the software renderer. A benchmark,
// no test: build/release/bin/frame_cost

#include <cstdio>
#include <ctime>
#include <string>

#include "03_damping/exact.hpp"
#include "05_ball_collision/picture/balls_picture.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "08_racket_game/picture/game_view.hpp"
#include "app/side_view.hpp"
#include "app/window.hpp"
#include "run_with.hpp"

using namespace bounce;

namespace {

/// Frames of 1/60 s in a hidden window, after as many that are not counted.
void measure(const std::string& name, const Demo& demo, std::unique_ptr<Simulation> simulation,
             int frames) {
  Window window(demo, std::move(simulation), Options{}, false);
  for (int i = 0; i < frames; ++i) window.tick(1.0 / 60);
  // The processor's time, not the clock on the wall: others may be using this machine.
  const auto seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  double picture = 0, all = 0;
  for (int i = 0; i < frames; ++i) {
    const double begin = seconds();
    window.tick(0);  // the picture alone, and a copy for scrubbing
    const double drawn = seconds();
    window.tick(1.0 / 60);
    picture += drawn - begin;
    all += seconds() - drawn;
  }
  std::printf("%-15s picture %6.2f ms, physics %6.2f ms a frame\n", name.c_str(),
              1e3 * picture / frames, 1e3 * (all - picture) / frames);
}

}  // namespace

int main() {
  setenv("SDL_VIDEODRIVER", "dummy", 0);
  measure("one ball", side_demo<Damping, DampingExact>(),
          std::make_unique<OneBallRun<Damping, DampingExact>>(), 120);
  Demo balls;
  balls.make = [] { return std::make_unique<BallsRun>(); };
  use_balls_picture(balls);
  for (const char* count : {"300", "1000", "10000"}) {
    auto run = std::make_unique<BallsRun>();
    test::set_up(*run, {{"scene", "drop"}, {"count", count}});
    measure(std::string(count) + " balls", balls, std::move(run), 60);
  }
  Demo game;
  game.make = [] { return std::make_unique<GameRun>(); };
  game.bare = true;
  use_game_view(game);
  for (const char* mode : {"keep-up", "target", "blind"}) {
    auto run = std::make_unique<GameRun>();
    run->play_as(PlayerKind::autopilot);
    test::set_up(*run, {{"mode", mode}});
    measure(std::string("game, ") + mode, game, std::move(run), 300);
  }
  measure("game, a loss", game, std::make_unique<GameRun>(), 420);  // nobody's hands
}
