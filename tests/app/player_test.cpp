#include "app/player.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "03_damping/exact.hpp"
#include "floating_point_traps.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;

namespace {

using DampedRun = OneBallRun<Damping, DampingExact>;

constexpr double frame = 1.0 / 60;

Player player_with(double dt, Method method = methods::semi_implicit_euler) {
  auto run = std::make_unique<DampedRun>();
  run->use_dt(dt);
  run->use_method(method);
  return Player(std::move(run));
}

void play(Player& player, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 60)); ++i) player.frame(frame);
}

}  // namespace

TEST_CASE("the window's run is the headless run, to the bit, whatever the frames") {
  for (const double dt : {1e-3, 7e-4, 0.013, 0.1}) {
    for (const double frame_time : {1.0 / 60, 1.0 / 144, 0.037}) {
      Player player = player_with(dt);
      for (int i = 0; i < 100; ++i) player.frame(frame_time);
      DampedRun headless;
      headless.use_dt(dt);
      headless.advance_to(player.simulation().time());
      CAPTURE(dt);
      CAPTURE(frame_time);
      CHECK(player.simulation().values() == headless.values());
      CHECK(player.simulation().steps() == headless.steps());
      // The picture never shows what is more than a step from the computed.
      CHECK(player.shown_time() <= player.simulation().time() + 1e-9);
      CHECK(player.shown_time() > player.simulation().time() - dt - 1e-9);
    }
  }
}

TEST_CASE("a stall of 30 s moves on by 0.1 s, and does not explode") {
  Player player = player_with(1e-3);
  play(player, 0.4);
  const double before = player.shown_time();
  player.frame(30);
  CHECK(player.shown_time() == doctest::Approx(before + 0.1).epsilon(1e-9));
  CHECK(player.trouble().empty());
}

TEST_CASE("where computing is slower than the clock, time runs slower, with the same steps") {
  struct Slow {
    double dt;
    double steps;  // that a frame gets done: the clock is looked at after 1000, and 4 times a frame
  };
  for (const Slow& slow : {Slow{1e-6, 1000}, Slow{1e-7, 1000}, Slow{1e-5, 417}}) {
    const double dt = slow.dt, steps = slow.steps;
    auto run = std::make_unique<DampedRun>();
    run->use_dt(dt);
    double now = 0;
    Player player(std::move(run), [&now] { return now += 0.02; });  // a look takes all the budget
    for (int i = 0; i < 120; ++i) player.frame(frame);
    CAPTURE(dt);
    CHECK(player.trouble().empty());
    CHECK(std::abs(static_cast<double>(player.simulation().steps()) / 120 - steps) < 0.51);
    CHECK(player.shown_time() == doctest::Approx(player.simulation().time()).epsilon(1e-3));
    // A mean over half a second, which began at 1 two seconds ago: the rest of that is e^-4.
    CHECK(std::abs(player.pace() - steps * dt / frame) < 0.02);
    DampedRun headless;
    headless.use_dt(dt);
    headless.advance_to(player.simulation().time());
    CHECK(player.simulation().values() == headless.values());
    CHECK(player.simulation().steps() == headless.steps());
    // Given more time, it catches nothing up, but keeps up from here on.
    player.budget = std::numeric_limits<double>::infinity();
    const double before = player.shown_time();
    player.frame(frame);
    CHECK(player.shown_time() == doctest::Approx(before + frame).epsilon(1e-12));
  }
}

TEST_CASE("a computer that is fast enough plays at the pace of the clock") {
  double now = 0;
  Player player(std::make_unique<DampedRun>(), [&now] { return now += 1e-4; });
  play(player, 1);
  CHECK(player.pace() == 1);
  CHECK(player.shown_time() == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("one step forward and one back is where it was, to the bit") {
  for (const Method method : {methods::explicit_euler, methods::semi_implicit_euler,
                              methods::velocity_verlet, methods::rk4}) {
    Player player = player_with(3e-3, method);
    play(player, 0.45);  // into the contact
    player.paused = true;
    const auto before = player.simulation().memory().numbers;
    const double t = player.simulation().time();
    for (int i = 0; i < 5; ++i) player.step_forward();
    CHECK(player.simulation().time() == doctest::Approx(t + 5 * 3e-3));
    for (int i = 0; i < 5; ++i) player.step_back();
    CHECK(player.simulation().time() == doctest::Approx(t).epsilon(1e-12));
    CHECK(player.simulation().memory().numbers == before);
    for (int i = 0; i < 20; ++i) player.step_back();  // also across frames
    CHECK(player.simulation().time() == doctest::Approx(t - 20 * 3e-3).epsilon(1e-9));
  }
}

TEST_CASE("going back by the scrub bar and playing on repeats the same run") {
  Player player = player_with(1e-3);
  play(player, 2);
  DampedRun headless;
  player.go_back_to(0.9);
  CHECK(player.simulation().time() == doctest::Approx(0.9).epsilon(2e-3));
  CHECK(player.trace().back().t <= player.simulation().time());
  play(player, 0.5);
  headless.advance_to(player.simulation().time());
  CHECK(player.simulation().values() == headless.values());
  player.go_back_to(-1);  // as far as it remembers
  CHECK(player.simulation().time() == doctest::Approx(player.earliest()));
}

TEST_CASE("the contact lens slows the clock in contact, and changes nothing in the run") {
  Player player = player_with(1e-4);
  player.contact_lens = true;
  int frames_in_contact = 0;
  while (player.shown_time() < 0.6) {
    player.frame(frame);
    if (player.current_rate() < 0.5) ++frames_in_contact;
  }
  // A contact of 32 ms is spread over about a second: 60 frames.
  CHECK(frames_in_contact > 50);
  CHECK(frames_in_contact < 75);
  DampedRun headless;
  headless.use_dt(1e-4);
  headless.advance_to(player.simulation().time());
  CHECK(player.simulation().values() == headless.values());
}

TEST_CASE(
    "the energy that is neither here nor taken by the damper is the method's error, and small") {
  for (const double dt : {1e-4, 2e-5}) {
    Player player = player_with(dt);
    play(player, 2);
    const TracePoint& now = player.trace().back();
    CAPTURE(dt);
    CHECK(now.lost > 2);  // two bounces at c = 5 take 1.3 and 1.1 J
    // First order: two touches, each counted up to a step too late, at a damper power of c v^2 = 88
    // W.
    CHECK(std::abs(now.energy_error()) < 4 * 88 * dt + 0.02 * 100 * dt);
  }
}

TEST_CASE("the future is what then happens") {
  Player player = player_with(1e-3);
  play(player, 0.3);
  const auto future = player.future(1);
  REQUIRE(!future.empty());
  DampedRun headless;
  for (const TracePoint& point : future) {
    headless.advance_to(point.t);
    CHECK(headless.values() == point.values);
  }
}

TEST_CASE("a run that explodes stops with a sentence and no NaN in sight") {
  auto run = std::make_unique<DampedRun>();
  const test::WithoutTraps it_explodes;
  // c dt / m = 1e70: see the command line's test.
  find_parameter(run->parameters(), "damping").set("1e30");
  find_parameter(run->parameters(), "velocity").set("-1");
  find_parameter(run->parameters(), "mass").set("1e-30");
  find_parameter(run->parameters(), "stiffness").set("1e30");
  find_parameter(run->parameters(), "position").set("0.05");
  run->use_method(methods::rk4);
  run->use_dt(1e10);
  run->restart();
  Player player(std::move(run));
  for (int i = 0; i < 20 && player.trouble().empty(); ++i) player.step_forward();
  CHECK(player.trouble().find("infinite") != std::string::npos);
  for (const TracePoint& point : player.trace()) CHECK(std::isfinite(point.values[0]));
  player.restart();
  CHECK(player.trouble().empty());
  CHECK(player.simulation().time() == 0);
}

TEST_CASE("a parameter that is changed in the middle starts the comparison anew from there") {
  Player player = player_with(1e-3, methods::rk4);
  play(player, 0.44);  // in contact: the stored energy jumps with the stiffness
  player.change([](Simulation& s) { find_parameter(s.parameters(), "stiffness").set("40000"); });
  CHECK(player.simulation().energy_account().before == player.simulation().energy().total());
  CHECK(player.simulation().error()->position == 0);
  play(player, 0.3);
  CHECK(player.simulation().error()->position < 1e-2);
}
