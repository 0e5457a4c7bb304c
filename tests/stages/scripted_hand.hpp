#pragma once
#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "08_racket_game/game/game_run.hpp"
#include "random_numbers.hpp"

namespace bounce::test {

/// A hand as of somebody who never played: it sees what was 0.2 s ago, and works out from there
/// where and when the ball comes down. Once a flight it misses the place by 3 cm and the time by
/// 30 ms (standard deviations). It does not tilt.
class ScriptedHand {
 public:
  static constexpr double frame = 0.016;  // s: whole steps, as a window takes them
  static constexpr double delay = 0.2, aiming = 0.03, timing = 0.03;  // s, m, s

  explicit ScriptedHand(unsigned seed) : random_(seed) {}

  /// Plays until the round is lost, or that time has come.
  void play(GameRun& run, double until) {
    while (!run.round().score.lost && run.time() < until) {
      run.want(now(run));
      run.advance_to(run.time_of_next_step() + frame - run.dt());
    }
  }

 private:
  Input now(const GameRun& run) {
    const double t = run.round().clock;
    seen_.push_back({t, view_of(run.settings(), run.round())});
    while (seen_.size() > 1 && seen_[1].t <= t - delay) seen_.pop_front();
    const auto& [then, sight] = seen_.front();
    // A new flight: it was touched, which shows in a velocity that grew.
    if (sight.ball.velocity.y() > up_ + 0.1) miss();
    up_ = sight.ball.velocity.y();

    const double swing = swing_speed(sight.gravity);
    const Landing next =
        landing(sight.ball, sight.gravity, sight.home.y() + sight.ball_radius + rules::stroke / 2);
    if (next.after == never) return input_;
    const auto reached = [](double aim, double home) {
      return std::clamp(aim, home - rules::court, home + rules::court);
    };
    input_.x = reached(next.place.x() + beside_x_, sight.home.x());
    input_.z = reached(next.place.z() + beside_z_, sight.home.z());
    const double meets = then + next.after + late_;
    const double lead = rules::stroke / 2 / swing + 0.02;
    input_.swing = t > meets - lead && t < meets + 0.1 ? 1 : 0;
    return input_;
  }
  void miss() {
    Normal one;
    beside_x_ = aiming * one(random_);
    beside_z_ = aiming * one(random_);
    late_ = timing * one(random_);
  }

  struct Seen {
    double t;
    PlayerView sight;
  };
  std::deque<Seen> seen_;
  std::mt19937 random_;
  double up_ = -1e9, beside_x_ = 0, beside_z_ = 0, late_ = 0;
  Input input_;
};

}  // namespace bounce::test
