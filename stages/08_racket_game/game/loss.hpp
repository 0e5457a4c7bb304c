#pragma once
#include <span>
#include <string>
#include <vector>

#include "08_racket_game/game/game_run.hpp"

namespace bounce {

/// The game at one moment, for those who look at it again.
struct Moment {
  double t;  // on the round's clock [s]
  State<Eigen::Vector3d> ball;
  Disc disc;             // with its velocities
  Eigen::Vector3d push;  // of the racket on the ball [N]
  NearestPoint nearest;
  long long touches;  // so far
};
Moment moment_of(const GameRun& run);

/// The same steps again, to the end of the round, which came at `until` on its clock: an earlier
/// copy of a run comes to the same bits. (If its time step was changed since, it may not, and ends
/// there.)
std::vector<Moment> watch_again(GameRun run, double until);

/// Between two moments.
Moment between(const Moment& a, const Moment& b, double t);

/// What there is to say about a loss, in numbers from the last seconds.
struct Loss {
  enum Cause { no_touch, slid_off, rim, tilted, downwards, early, late, no_swing, elsewhere };
  Cause cause = no_touch;
  double off_by = 0;    // s that the swing was too early, or too late
  double racket = 0;    // its speed upwards at the touch [m/s]
  double lean = 0;      // of the disc at the touch [rad]
  double beside = 0;    // m from the disc's centre, where it was touched
  double sideways = 0;  // m/s, with which the ball left
  double rose = 0;      // m above where it left
  double flight = 0;    // s from there until it was back at the disc's height
  double missed = 0;    // m from the disc's centre, as it fell past it; 0: it did not
  double beyond = 0;    // m from the rim
};
/// `swing` is the speed of a swing then [m/s], `gravity` that of then.
Loss loss_of(std::span<const Moment> moments, double swing, double gravity);
/// As a sentence.
std::string to_sentence(const Loss& loss);

}  // namespace bounce
