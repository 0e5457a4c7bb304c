// The window with many balls: bounded in what it computes and remembers.

#include <doctest/doctest.h>

#include "05_ball_collision/picture/balls_picture.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "app/window.hpp"
#include "run_with.hpp"

using namespace bounce;
using test::set;

namespace {

std::unique_ptr<BallsRun> falling_balls(const std::string& count) {
  auto balls = std::make_unique<BallsRun>();
  set(*balls, "scene", "drop");
  set(*balls, "count", count);
  balls->restart();
  return balls;
}

Demo balls_demo() {
  Demo demo;
  demo.stage = {"05_ball_collision", "test"};
  demo.question = "?";
  demo.sliders = {"scene", "gap", "count"};
  demo.make = [] { return std::make_unique<BallsRun>(); };
  use_balls_picture(demo);
  return demo;
}

}  // namespace

TEST_CASE("10,000 balls, steps of 0.1 ms: a frame computes for as long as it may, and no longer") {
  auto balls = falling_balls("10000");
  balls->use_dt(1e-4);
  double now = 0;
  Playback playback(std::move(balls), [&now] { return now += 0.02; });  // a look takes all it may
  constexpr int frames = 20;
  for (int i = 0; i < frames; ++i) playback.frame(1.0 / 60);
  CHECK(playback.simulation().steps() >= frames);       // it does go on
  CHECK(playback.simulation().steps() <= 42 * frames);  // a quarter of the frame's 167 steps
  CHECK(playback.pace() < 1);
}

TEST_CASE("balls that come too close together stop the window's run, with a sentence") {
  // So many that fly into one place would touch in 25 million pairs.
  constexpr int count = 7000;
  Arrangement row(count);
  for (int i = 0; i < count; ++i) {
    row.balls.position.col(i) << 0.25 * i, 1, 0;
    row.balls.velocity.col(i) << -0.25 * i / 0.1, 0, 0;
  }
  auto balls = std::make_unique<BallsRun>();
  balls->world().use_balls(row, "--balls 'row'");
  balls->restart();
  const Demo demo = balls_demo();
  Window window(demo, std::move(balls), Options{}, false);
  Playback& playback = window.playback();
  for (int i = 0; i < 12 && playback.trouble().empty(); ++i) CHECK(window.tick(1.0 / 60));
  CAPTURE(playback.trouble());
  CHECK(playback.trouble().find("not allowed: spread them out, or take fewer") !=
        std::string::npos);
  CHECK(playback.is_refused());
  CHECK(window.tick(1.0 / 60));  // it stays open, and shows where it was before
  const double stopped = playback.simulation().time();
  CHECK(stopped > 0);
  CHECK(stopped < 0.1);
  CHECK(playback.simulation().memory().numbers.size() >
        8 * count);  // a whole state: --save takes it
  CHECK(playback.trace().back().t <= stopped);
  playback.step_back();
  CHECK(playback.trouble().empty());
  CHECK(playback.simulation().time() < stopped);
  playback.restart();
  CHECK(playback.trouble().empty());
  CHECK(playback.simulation().time() == 0);
}

TEST_CASE("what the playback remembers of many balls is bounded, and scrubbing back still works") {
  Playback playback(falling_balls("20000"));
  const std::size_t row = 7 * 20000;
  for (int i = 0; i < 12; ++i) playback.frame(1e-3);
  std::size_t numbers = 0;
  for (const TracePoint& point : playback.trace()) numbers += point.values.size();
  CHECK(numbers <= 101 * row);
  const double t = playback.simulation().time();
  playback.go_back_to(t - 2e-3);
  CHECK(playback.simulation().time() < t);
  CHECK(playback.shown_values().size() == row);
}

TEST_CASE("the trace of many balls drops old positions, and keeps time and energy for the plots") {
  Playback playback(
      falling_balls("5000"));  // 4e6 / 35000: the last 114 points keep their positions
  for (int i = 0; i < 130; ++i) playback.step_forward();
  CHECK(playback.trace().front().t == 0);
  CHECK(playback.trace().front().values.empty());
  CHECK(playback.trace().front().energy.gravitational > 0);
  CHECK(playback.trace().back().values.size() == 35000);
  playback.go_back_to(playback.earliest());
  CHECK(playback.shown_values().size() == 35000);
}
