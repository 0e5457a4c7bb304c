#include "app/playback.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "03_damping/exact.hpp"
#include "floating_point_traps.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using test::set;

namespace {

using DampedRun = OneBallRun<Damping, DampingExact>;

constexpr double a_sixtieth = 1.0 / 60;

Playback playback_with(double dt, Method method = methods::semi_implicit_euler) {
  auto run = std::make_unique<DampedRun>();
  run->use_dt(dt);
  run->use_method(method);
  return Playback(std::move(run));
}

void play(Playback& playback, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 60)); ++i) playback.frame(a_sixtieth);
}

}  // namespace

TEST_CASE("the window's run is the headless run, to the bit, whatever the frames") {
  for (const double dt : {1e-3, 7e-4, 0.013, 0.1}) {
    for (const double real_time : {1.0 / 60, 1.0 / 144, 0.037}) {
      Playback playback = playback_with(dt);
      for (int i = 0; i < 100; ++i) playback.frame(real_time);
      DampedRun headless;
      headless.use_dt(dt);
      headless.advance_to(playback.simulation().time());
      CAPTURE(dt);
      CAPTURE(real_time);
      CHECK(playback.simulation().values() == headless.values());
      CHECK(playback.simulation().steps() == headless.steps());
      // The picture never shows what is more than a step from the computed.
      CHECK(playback.shown_time() <= playback.simulation().time() + 1e-9);
      CHECK(playback.shown_time() > playback.simulation().time() - dt - 1e-9);
    }
  }
}

TEST_CASE("a stall of 30 s moves on by 0.1 s, and does not explode") {
  Playback playback = playback_with(1e-3);
  play(playback, 0.4);
  const double before = playback.shown_time();
  playback.frame(30);
  CHECK(playback.shown_time() == doctest::Approx(before + 0.1).epsilon(1e-9));
  CHECK(playback.trouble().empty());
}

TEST_CASE("where computing is slower than the clock, time runs slower, with the same steps") {
  for (const double dt : {1e-5, 1e-6, 1e-7}) {
    auto run = std::make_unique<DampedRun>();
    run->use_dt(dt);
    double now = 0;
    Playback playback(std::move(run),
                      [&now] { return now += 0.02; });  // a look takes all the budget
    for (int i = 0; i < 120; ++i) playback.frame(a_sixtieth);
    CAPTURE(dt);
    CHECK(playback.trouble().empty());
    const double steps = static_cast<double>(playback.simulation().steps()) / 120;  // a frame
    CHECK(steps >= 1);
    CHECK(steps * dt < a_sixtieth / 2);
    CHECK(playback.shown_time() == doctest::Approx(playback.simulation().time()).epsilon(1e-3));
    // A mean over half a second, which began at 1 two seconds ago: the rest of that is e^-4.
    CHECK(std::abs(playback.pace() - steps * dt / a_sixtieth) < 0.02);
    DampedRun headless;
    headless.use_dt(dt);
    headless.advance_to(playback.simulation().time());
    CHECK(playback.simulation().values() == headless.values());
    CHECK(playback.simulation().steps() == headless.steps());
    // Given more time, it catches nothing up, but keeps up from here on.
    playback.budget = std::numeric_limits<double>::infinity();
    const double before = playback.shown_time();
    playback.frame(a_sixtieth);
    CHECK(playback.shown_time() == doctest::Approx(before + a_sixtieth).epsilon(1e-12));
  }
}

TEST_CASE("a computer that is fast enough plays at the pace of the clock") {
  double now = 0;
  Playback playback(std::make_unique<DampedRun>(), [&now] { return now += 1e-4; });
  play(playback, 1);
  CHECK(playback.pace() == 1);
  CHECK(playback.shown_time() == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("one step forward and one back is where it was, to the bit") {
  for (const Method method : {methods::explicit_euler, methods::semi_implicit_euler,
                              methods::velocity_verlet, methods::rk4}) {
    Playback playback = playback_with(3e-3, method);
    play(playback, 0.45);  // into the contact
    playback.paused = true;
    const auto before = playback.simulation().memory().numbers;
    const double t = playback.simulation().time();
    for (int i = 0; i < 5; ++i) playback.step_forward();
    CHECK(playback.simulation().time() == doctest::Approx(t + 5 * 3e-3));
    for (int i = 0; i < 5; ++i) playback.step_back();
    CHECK(playback.simulation().time() == doctest::Approx(t).epsilon(1e-12));
    CHECK(playback.simulation().memory().numbers == before);
    for (int i = 0; i < 20; ++i) playback.step_back();  // also across frames
    CHECK(playback.simulation().time() == doctest::Approx(t - 20 * 3e-3).epsilon(1e-9));
  }
}

TEST_CASE("going back by the scrub bar and playing on repeats the same run") {
  Playback playback = playback_with(1e-3);
  play(playback, 2);
  DampedRun headless;
  playback.go_back_to(0.9);
  CHECK(playback.simulation().time() == doctest::Approx(0.9).epsilon(2e-3));
  CHECK(playback.trace().back().t <= playback.simulation().time());
  play(playback, 0.5);
  headless.advance_to(playback.simulation().time());
  CHECK(playback.simulation().values() == headless.values());
  playback.go_back_to(-1);  // as far as it remembers
  CHECK(playback.simulation().time() == doctest::Approx(playback.earliest()));
}

TEST_CASE("the contact lens slows the clock in contact, and changes nothing in the run") {
  Playback playback = playback_with(1e-4);
  playback.contact_lens = true;
  int frames_in_contact = 0;
  while (playback.shown_time() < 0.6) {
    playback.frame(a_sixtieth);
    if (playback.current_rate() < 0.5) ++frames_in_contact;
  }
  // A contact of 32 ms is spread over about a second: 60 frames.
  CHECK(frames_in_contact > 50);
  CHECK(frames_in_contact < 75);
  DampedRun headless;
  headless.use_dt(1e-4);
  headless.advance_to(playback.simulation().time());
  CHECK(playback.simulation().values() == headless.values());
}

TEST_CASE(
    "the energy that is neither here nor taken by the damper is the method's error, and small") {
  for (const double dt : {1e-4, 2e-5}) {
    Playback playback = playback_with(dt);
    play(playback, 2);
    const TracePoint& now = playback.trace().back();
    CAPTURE(dt);
    CHECK(now.lost > 2);  // two bounces at c = 5 take 1.3 and 1.1 J
    // First order: two touches, each counted up to a step too late, at a damper power of c v^2 = 88
    // W.
    CHECK(std::abs(now.energy_error()) < 4 * 88 * dt + 0.02 * 100 * dt);
  }
}

TEST_CASE("the future is what then happens") {
  Playback playback = playback_with(1e-3);
  play(playback, 0.3);
  const auto future = playback.future(1);
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
  set(*run, "damping", "1e30");
  set(*run, "velocity", "-1");
  set(*run, "mass", "1e-30");
  set(*run, "stiffness", "1e30");
  set(*run, "position", "0.05");
  run->use_method(methods::rk4);
  run->use_dt(1e10);
  run->restart();
  Playback playback(std::move(run));
  for (int i = 0; i < 20 && playback.trouble().empty(); ++i) playback.step_forward();
  CHECK(playback.trouble().find("infinite") != std::string::npos);
  for (const TracePoint& point : playback.trace()) CHECK(std::isfinite(point.values[0]));
  playback.restart();
  CHECK(playback.trouble().empty());
  CHECK(playback.simulation().time() == 0);
}

TEST_CASE("a parameter that is changed in the middle starts the comparison anew from there") {
  Playback playback = playback_with(1e-3, methods::rk4);
  play(playback, 0.44);  // in contact: the stored energy jumps with the stiffness
  playback.change([](Simulation& s) { set(s, "stiffness", "40000"); });
  CHECK(playback.simulation().energy_account().before == playback.simulation().energy().total());
  CHECK(playback.simulation().error()->position == 0);
  play(playback, 0.3);
  CHECK(playback.simulation().error()->position < 1e-2);
}
