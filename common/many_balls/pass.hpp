#pragma once
#include <array>

#include "many_balls/ball_record.hpp"
#include "physics/contact.hpp"

namespace bounce::many {

/// What acts on the balls, as in stage 5. y is up.
struct Laws {
  double gravity = 9.81;  // m/s^2
  SpringDamper between_balls;
  SpringDamper surfaces;         // floor and walls
  bool floor = true;             // at height 0
  std::array<double, 2> tray{};  // m: walls at x = 0 and LX, z = 0 and LZ; 0: none that way
};

/// One pass over the balls: the force on each, what the force does to its velocity, and what the
/// velocity does to its position. It reads one set of records and writes another, so that every
/// ball sees all others as they were.
struct Pass {
  Laws laws;
  const BallRecord* from;
  BallRecord* to;
  // The neighbours of slot s stand in the rows row[s / 8] to row[s / 8 + 1] of `neighbours`, place
  // s % 8 of each, in the order of their numbers. After the last one there are `rows_ahead` more.
  const Slot* row;
  const Slot* neighbours;
  const int* number;               // of each slot
  double touch = 0;                // m: the sum of two radii where all are equal, else 0
  int kicks = 0;                   // velocity += acceleration * kick, so many times;
  double kick = 0;                 // s
  double drift = 0;                // s; then position += velocity * drift
  double* acceleration = nullptr;  // m/s^2: three for each number are written here, if it is there
};

/// Does the slots from `first` (a multiple of eight) to before `last`, and returns the square of
/// the fastest one's new speed [m^2/s^2]. The same bits in every variant: a ball's forces are added
/// in the same order everywhere, and the width only says how many balls go side by side.
using PassFunction = double (*)(const Pass& pass, Slot first, Slot last);

double pass_scalar(const Pass& pass, Slot first, Slot last);
double pass_vector(const Pass& pass, Slot first, Slot last);  // as wide as the build allows
#if BOUNCE_WIDER_PASSES
double pass_avx2(const Pass& pass, Slot first, Slot last);
double pass_avx512(const Pass& pass, Slot first, Slot last);
#endif

/// The widest one that this processor can do.
PassFunction fastest_pass();

}  // namespace bounce::many
