// The window with many balls: fast enough, and bounded in what it remembers.

#include <doctest/doctest.h>

#include <ctime>

#include "05_ball_collision/picture/balls_picture.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "app/window.hpp"

using namespace bounce;

namespace {

std::unique_ptr<BallsRun> falling_balls(const std::string& count) {
  auto balls = std::make_unique<BallsRun>();
  find_parameter(balls->parameters(), "scene").set("drop");
  find_parameter(balls->parameters(), "count").set(count);
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

/// Processor time of a frame [s] in a small window of the software renderer, physics and picture.
struct CpuCost {
  double physics, picture;
};

CpuCost frame_cost(const std::string& count, int frames) {
  const Demo demo = balls_demo();
  Window window(demo, falling_balls(count), Options{}, false);
  window.resize(640, 360);
  window.playback().budget = Playback::frame_budget;  // as where somebody looks
  double drawing = 0, all = 0;
  for (int i = 0; i < frames; ++i) {
    // The processor's time, not the clock on the wall: others may be using this machine.
    const std::clock_t begin = std::clock();
    const auto since = [begin] {
      return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    window.tick(0);  // the picture alone (and a copy for scrubbing)
    drawing += since();
    window.tick(1.0 / 60);
    all += since();
  }
  const CpuCost cost{(all - 2 * drawing) / frames, drawing / frames};
  MESSAGE(count, " balls, ms a frame: physics ", cost.physics * 1e3, ", picture ",
          cost.picture * 1e3);
  return cost;
}

TEST_CASE("1,000 balls: more than 30 frames a second in the software renderer") {
  [[maybe_unused]] const CpuCost cost =
      frame_cost("1000", 90);  // 1.5 s: they have fallen and lie in the tray
#ifdef NDEBUG
  CHECK(cost.physics + cost.picture < 1.0 / 30);
#endif
}

TEST_CASE("10,000 balls: 8 frames a second in the software renderer") {
  [[maybe_unused]] const CpuCost cost = frame_cost("10000", 60);
#ifdef NDEBUG
  CHECK(cost.physics + cost.picture < 1.0 / 8);
#endif
}

TEST_CASE("10,000 balls, steps of 0.1 ms: a frame's physics takes no longer than it may") {
  auto balls = falling_balls("10000");
  balls->use_dt(1e-4);
  Playback playback(std::move(balls));
  playback.frame(1.0 / 60);  // the first one makes the lists
  const std::clock_t begin = std::clock();
  constexpr int frames = 20;
  for (int i = 0; i < frames; ++i) playback.frame(1.0 / 60);
  const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / frames;
  MESSAGE("ms of physics a frame: ", spent * 1e3, ", pace ", playback.pace());
  CHECK(playback.simulation().steps() >= frames);  // it does go on
  // 12 ms, one step more (3 ms), the point of the trace and the copy for scrubbing. A frame needs
  // 167 steps, half a second, to keep up.
  [[maybe_unused]] const double allowed = 0.03;
#ifdef NDEBUG
  CHECK(spent < allowed);
#endif
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
  CHECK(playback.trace().size() == 131);
  CHECK(playback.trace().front().values.empty());
  CHECK(playback.trace().front().energy.gravitational > 0);
  CHECK(playback.trace().back().values.size() == 35000);
  playback.go_back_to(playback.earliest());
  CHECK(playback.shown_values().size() == 35000);
}
