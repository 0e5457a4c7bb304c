// After a loss one sentence says why. Rounds whose cause is planted: each time a hand does
// everything right but one thing, and then leaves the racket where it is.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "08_racket_game/game/loss.hpp"
#include "run_with.hpp"

using namespace bounce;

namespace {

constexpr double frame = 0.016;  // s: whole steps, as a window takes them

/// Plays a round to its end. `aside` is the ball's velocity at the start [m/s]: so fast that a
/// racket that stays where it is misses the next flight.
Loss lose(const std::string& aside, const std::function<Input(const GameRun&)>& hand) {
  GameRun run;
  run.use_seed(5);
  test::set_up(run, {{"assist", "0"}, {"velocity", aside}});
  run.record(std::make_shared<InputLog>());
  run.restart();
  GameRun again = run;
  while (!run.round().score.lost && run.time() < 60) {
    run.want(hand(run));
    run.advance_to(run.time_of_next_step() + frame - run.dt());
  }
  REQUIRE(run.round().score.lost);

  again.repeat();
  const std::vector<Moment> moments = watch_again(again, run.round().lost_clock);
  // It is the same round, to the bit.
  CHECK(moments.back().ball.position == run.round().ball.position);
  CHECK(moments.back().touches == run.round().touches);
  return loss_of(moments, swing_speed(run.gravity()), run.gravity());
}

/// A hand that keeps the disc below the ball, or so far beside it [m], up to the first touch, and
/// stays there. The rest is up to `fault`, which sees how long it is until the ball meets the
/// lowered racket (negative: since it did) [s].
std::function<Input(const GameRun&)> follows(const std::function<void(Input&, double)>& fault,
                                             double beside = 0) {
  return [fault, beside, last = Input{}, met = never](const GameRun& run) mutable {
    const PlayerView sight = view_of(run.settings(), run.round());
    const Landing next = landing(sight.ball, sight.gravity, sight.home.y() + sight.ball_radius);
    if (run.round().touches == 0) {
      last.x = next.place.x() + beside;
      last.z = next.place.z();
      met = run.round().clock + next.after;
    }
    fault(last, met - run.round().clock);
    return last;
  };
}

void check(const Loss& loss, Loss::Cause cause, const std::string& words) {
  const std::string sentence = to_sentence(loss);
  CHECK_MESSAGE(loss.cause == cause, sentence);
  CHECK_MESSAGE(sentence.find(words) != std::string::npos, sentence);
  CHECK_MESSAGE(sentence.back() == '.', sentence);
}

const double swing = swing_speed(4);         // m/s, in the first flight
const double lasts = rules::stroke / swing;  // s that it goes up
const double half_stroke = lasts / 2;        // s: the middle of the stroke is at the touch

}  // namespace

TEST_CASE("stage 8, a loss: no touch at all") {
  const Loss loss = lose("0,0,0", [](const GameRun&) { return Input{0.7, 0.3}; });
  check(loss, Loss::no_touch, "No touch: the ball came down ");
  // The serve pushes it aside with 0.25 m/s at most, for the second or so that it takes.
  CHECK(std::abs(loss.missed - std::hypot(0.7, 0.3)) < 0.25 * 1.2);
  CHECK(loss.beyond == doctest::Approx(loss.missed - 0.3));
}

TEST_CASE("stage 8, a loss: the swing was over, and how long ago") {
  for (const double early : {0.1, 0.25}) {
    const Loss loss = lose("0.9,0,0", follows([early](Input& input, double until) {
                             input.swing = until < lasts + early ? 1 : 0;
                           }));
    check(loss, Loss::early, "Too early by ");
    // The lifted racket meets the ball sooner by the time of a stroke's fall, some 50 ms; it brakes
    // over the last 10 ms; and the hand is heard once a frame.
    CHECK(loss.off_by > early - 0.07);
    CHECK(loss.off_by < early + 0.03);
  }
}

TEST_CASE("stage 8, a loss: the swing came after the touch, and how long") {
  for (const double late : {0.05, 0.2}) {
    const Loss loss =
        lose("0.9,0,0",
             follows([late](Input& input, double until) { input.swing = until < -late ? 1 : 0; }));
    check(loss, Loss::late, "Too late by ");
    CHECK(loss.off_by > late - 0.002);         // a step or two
    CHECK(loss.off_by < late + frame + 0.01);  // and half the speed is reached within 10 ms
  }
}

TEST_CASE("stage 8, a loss: the racket moved down at the touch") {
  const Loss loss = lose(
      "0.9,0,0", follows([](Input& input, double until) { input.swing = until > 0.15 ? 1 : 0; }));
  check(loss, Loss::downwards, "The racket moved down with ");
  CHECK(loss.racket < 0);
  CHECK(loss.racket >= -swing);
}

TEST_CASE("stage 8, a loss: nobody swung") {
  const Loss loss = lose("0.9,0,0", follows([](Input&, double) {}));
  check(loss, Loss::no_swing, "No swing");
  // The ball leaves with 0.8 of its speed: of a fall from the serve's top, 1 + 1.2^2 / (2 g) over
  // the ground, 0.9 over the racket, it comes back to 0.64;
  // and gravity has grown from 4 to 4.25 by then.
  CHECK(loss.rose == doctest::Approx(0.64 * (0.9 + 1.2 * 1.2 / 8) * 4 / 4.25).epsilon(0.02));
}

TEST_CASE("stage 8, a loss: the disc leaned") {
  const Loss loss = lose("0.1,0,0", follows([](Input& input, double until) {
                           input.swing = until < half_stroke ? 1 : 0;
                           input.tilt_x = 1;
                         }));
  check(loss, Loss::tilted, "tilted by 8 degrees: the ball left to the side with ");
  CHECK(loss.lean == doctest::Approx(rules::largest_tilt).epsilon(0.01));
  CHECK(loss.beside < 0.05);
  CHECK(loss.beyond > 0);
}

TEST_CASE("stage 8, a loss: the ball was hit beside the centre, over the rim") {
  const Loss loss = lose("0,0,0", follows([](Input&, double) {}, 0.34));
  check(loss, Loss::rim, "Hit over the rim, ");
  CHECK(loss.beside == doctest::Approx(0.34).epsilon(0.05));
  CHECK(loss.sideways > 0.5);
}

TEST_CASE("stage 8, a loss: the ball came to rest, and slid off") {
  const Loss loss = lose("0,0,0", [](const GameRun& run) {
    Input input;  // level and still, below the ball, until that lies; then it leans
    input.x = run.round().ball.position.x();
    input.z = run.round().ball.position.z();
    if (run.time() < 15) return input;
    return Input{input.x + 0.1, input.z, -0.2};
  });
  check(loss, Loss::slid_off, "slid over the rim");
}

TEST_CASE("stage 8, a loss: all was right, and then the disc was elsewhere") {
  const Loss loss =
      lose("0.9,0,0",
           follows([](Input& input, double until) { input.swing = until < half_stroke ? 1 : 0; }));
  check(loss, Loss::elsewhere, "The hit was good, but the disc was elsewhere.");
  // 0.9 m/s, and what the serve and the hit push it aside: 0.25 and 0.12 m/s at most.
  CHECK(loss.missed > (0.9 - 0.37) * loss.flight);
  CHECK(loss.missed < (0.9 + 0.37) * loss.flight);
}
