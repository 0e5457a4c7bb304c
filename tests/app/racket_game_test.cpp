#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "08_racket_game/run/command_line.hpp"
#include "app/playback.hpp"
#include "run_program.hpp"

using namespace bounce;
namespace fs = std::filesystem;

TEST_CASE("the racket game draws itself, whoever plays") {
  const fs::path picture = fs::temp_directory_path() / "bounce_racket_game.png";
  for (const char* player :
       {"autopilot", "blind", "blind --set strike=speeding", "idle", "human --calm",
        "none --set racket_normal=0.2,-1,0", "none --set position=0,-1,0 --set velocity=0,6,0"}) {
    fs::remove(picture);
    const test::Outcome outcome =
        test::run_program(std::string("08_racket_game --player ") + player +
                          " --duration 3 --screenshot " + test::quoted(picture.string()));
    CAPTURE(player);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    REQUIRE(fs::exists(picture));
    CHECK(fs::file_size(picture) > 10000);  // more than an empty page
  }
  fs::remove(picture);
}

TEST_CASE("the racket game goes on by 0.1 s after a stall of 30 s, as if there had been none") {
  GameRun steady;
  steady.play_as(PlayerKind::autopilot);
  steady.use_seed(5);
  steady.restart();
  Playback playback(steady.clone());
  long long touches = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const double before = playback.shown_time();
    // Every third frame hangs: whatever the ball is doing then, in flight or in the racket.
    playback.frame(frame % 3 == 0 ? 30 : 1.0 / 60);
    CHECK(playback.shown_time() - before <= 0.1 + 1e-9);
    CHECK(playback.trouble().empty());
    // The same steps as in a run without a window: nothing was jumped over or caught up later.
    const GameRun& shown = run_as<GameRun>(playback.simulation());
    steady.advance_to(shown.time());
    REQUIRE(shown.values() == steady.values());
    touches = shown.round().touches;
    CHECK_FALSE(shown.round().score.lost);
    CHECK(shown.round().ball.velocity.norm() < 10);
  }
  CHECK(touches > 5);
}

TEST_CASE("after a stall the racket is where it could get in 0.1 s, not where the mouse is") {
  GameRun run;
  run.play_as(PlayerKind::human);
  run.restart();
  Playback playback(run.clone());
  for (int frame = 0; frame < 20; ++frame) playback.frame(1.0 / 60);
  GameRun& played = run_as<GameRun>(playback.simulation());
  const double before = played.disc().centre.x();
  Input far;  // the mouse moved on while the window hung
  far.x = 1.2;
  played.want(far);
  playback.frame(30);
  const double moved = run_as<GameRun>(playback.simulation()).disc().centre.x() - before;
  CHECK(moved > 0.01);
  CHECK(moved <= sideways.speed * 0.1);
}
