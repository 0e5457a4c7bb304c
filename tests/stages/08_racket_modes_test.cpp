// What counts in the game: points, the three modes, and that somebody who never played gets some.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "08_racket_game/run/command_line.hpp"
#include "random_numbers.hpp"
#include "run/save_load.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/scripted_hand.hpp"

using namespace bounce;
using test::ScriptedHand;
using test::Values;

namespace {

GameRun game_of(std::uint64_t seed, const Values& settings) {
  GameRun run;
  run.use_seed(seed);
  test::set_up(run, settings);
  return run;
}

/// 20 rounds of the scripted hand, of 60 s at most each: hits, in order.
std::vector<int> hits_of_rounds(const Values& settings) {
  std::vector<int> hits;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    GameRun run = game_of(seed, settings);
    ScriptedHand(seed).play(run, 60);
    hits.push_back(run.round().score.hits);
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}
double median(const std::vector<int>& sorted) {
  return (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2.0;
}

/// Swings at every beat, or at beats that are so many times as long, with 30 ms of noise.
GameRun on_beats(unsigned seed, double longer, double until) {
  GameRun run = game_of(seed, {{"mode", "blind"}});
  const Beat beat = beat_of(run.settings());
  std::mt19937 random(seed);
  test::Normal noise;
  double late = 0.03 * noise(random);
  int last = 0;
  while (!run.round().score.lost && run.time() < until) {
    const double t = run.round().clock - late;
    const double since = (t - beat.first) / (longer * beat.period);
    const int count = static_cast<int>(std::floor(since));
    if (count > last) late = 0.03 * noise(random);
    last = std::max(last, count);
    Input input;
    input.swing = t > beat.first && (since - std::floor(since)) * beat.period < 0.3 ? 1 : 0;
    run.want(input);
    run.advance_to(run.time_of_next_step() + 0.015);
  }
  return run;
}

}  // namespace

TEST_CASE("stage 8: who never played keeps the ball up, with some help and without") {
  // 0.2 s late, 3 cm beside, 30 ms off, and no tilt. What is measured: 7.5 and 56, of 56 in 60 s.
  CHECK(median(hits_of_rounds({{"assist", "0"}})) >= 3);
  CHECK(median(hits_of_rounds({{"assist", "30"}})) >= 8);
}

TEST_CASE("stage 8: a top in the band counts twice, to its edges") {
  CHECK(bonus_for_top(0.79) == 0);
  CHECK(bonus_for_top(0.8) == 1);
  CHECK(bonus_for_top(1.2) == 1);
  CHECK(bonus_for_top(1.21) == 0);
  // As played: one point for each hit, and one for each of its tops that was in there.
  GameRun run = game_of(4, {{"assist", "100"}});
  int in_band = 0;
  double before = 0;
  ScriptedHand hand(4);
  for (double until = 0.016; until < 40; until += 0.016) {
    hand.play(run, until);
    const double up = run.round().ball.velocity.y(), top = run.round().ball.position.y() - 0.1;
    // Within a frame of the top it is lower by less than 1 cm: not near the edges of the band.
    if (before > 0 && up <= 0 && run.round().score.hits > 0 && top > 0.79) {
      const bool inside = top > 0.8 && top < 1.2;
      in_band += inside ? 1 : 0;
    }
    before = up;
  }
  CHECK(in_band > 5);
  CHECK(run.round().points.total == run.round().score.hits + in_band);
  CHECK(run.round().points.best == run.round().points.total);
}

TEST_CASE("stage 8: the nearer to the ring's middle the ball will land, the more points") {
  CHECK(points_for_landing(0.05) == 3);
  CHECK(points_for_landing(0.15) == 2);
  CHECK(points_for_landing(0.3) == 1);
  CHECK(points_for_landing(0.36) == 0);
  // Rings lie within reach, everywhere in there, and come again with the same seed.
  double mean = 0;
  for (int hit = 0; hit < 1000; ++hit) {
    const Eigen::Vector3d place = target_after(hit, 7, 3);
    CHECK(place.norm() <= rules::target_reach);
    CHECK(place == target_after(hit, 7, 3));
    mean += place.norm() / 1000;
  }
  CHECK(mean == doctest::Approx(rules::target_reach * 2 / 3).epsilon(0.03));  // of a disc
  CHECK(target_after(1, 7, 3) != target_after(2, 7, 3));

  // Who aims gets more than who does not: of three points a hit.
  GameRun aimed = game_of(2, {{"mode", "target"}}), not_aimed = game_of(2, {{"mode", "target"}});
  aimed.play_as(PlayerKind::autopilot);
  aimed.restart();
  aimed.advance_to(60);
  test::set(not_aimed, "assist", "0");
  ScriptedHand(2).play(not_aimed, 60);
  const auto a_hit = [](const GameRun& run) {
    return static_cast<double>(run.round().points.total) / run.round().score.hits;
  };
  CHECK(a_hit(aimed) > 1.5);
  CHECK(a_hit(not_aimed) < 1);
}

TEST_CASE("stage 8: blind, who swings on the beat keeps the ball up, and who does not loses it") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const GameRun right = on_beats(seed, 1, 60), slow = on_beats(seed, 1.15, 60);
    CHECK(right.round().score.hits >= 30);  // with 30 ms of noise; a beat lasts about a second
    CHECK(right.round().points.total == right.round().score.hits);
    CHECK(slow.round().score.lost);
    CHECK(slow.round().score.hits < right.round().score.hits / 2);
  }
  // Nobody swings: tops of 0.64 of the one before, and 0.4 m is too low.
  GameRun still = game_of(1, {{"mode", "blind"}});
  still.advance_to(20);
  CHECK(still.round().score.lost);
  CHECK(still.round().score.hits == 3);
  // It stays where it is: straight up and down, and nothing becomes harder.
  CHECK(still.round().ball.position.x() == 0);
  CHECK(still.gravity() == 9.81);
}

TEST_CASE("stage 8: the beat is that of a ball at one height") {
  const Beat beat = beat_for(9.81, 0.8, 0.03);
  const double u = swing_speed(9.81);
  CHECK(0.8 * beat.speed + 1.8 * u == doctest::Approx(beat.speed));
  CHECK(beat.period == doctest::Approx(2 * beat.speed / 9.81 + 0.03));
  CHECK(beat.count(beat.first - 1e-6) == 0);
  CHECK(beat.count(beat.first + 1e-6) == 1);
  CHECK(beat.count(beat.first + 2 * beat.period + 1e-6) == 3);
  CHECK(beat.phase(beat.first + 0.25 * beat.period) == doctest::Approx(0.25));
  // Where there is none, nothing breaks.
  CHECK(beat_for(0, 0.8, 0.03).count(5) == 0);
  CHECK(std::isfinite(beat_for(9.81, 1, 0.03).period));
}

TEST_CASE("stage 8: every mode is recorded, and saved, to the bit") {
  const std::string path =
      (std::filesystem::temp_directory_path() / "bounce_stage_8_mode").string();
  for (const char* mode : {"keep-up", "target", "blind"}) {
    CAPTURE(mode);
    const auto log = std::make_shared<InputLog>();
    GameRun run = game_of(11, {{"mode", mode}});
    run.record(log);
    run.restart();
    ScriptedHand hand(3);
    hand.play(run, 6);
    const StageName stage{"08_racket_game", ""};
    save_state(path, stage, run);
    const GameRun resumed = test::loaded<GameRun>(path, stage);
    CHECK(resumed.memory().numbers == run.memory().numbers);
    CHECK(resumed.round().points.total == run.round().points.total);

    hand.play(run, 9);
    write_input_log(path, *log);
    GameRun again;
    again.replay(std::make_shared<const InputLog>(read_input_log(path)));
    again.restart();
    again.advance_to(run.time());
    CHECK(again.memory().numbers.size() == run.memory().numbers.size());
    CHECK(again.round().ball.position == run.round().ball.position);
    CHECK(again.round().points.total == run.round().points.total);
    CHECK(run.round().score.hits > 1);
  }
  std::filesystem::remove(path);
  // The key of the modes goes round.
  GameRun run = game_of(1, {});
  for (const char* mode : {"target", "blind", "keep-up"}) {
    run.use_next_mode();
    CHECK(mode_names[run.settings().mode] == mode);
  }
  CHECK(test::run_program("08_racket_game --headless --set mode=darts").code == 2);
}
