#pragma once
#include <cstdint>

namespace bounce::many {

/// A ball as it lies in memory here: 64 bytes, which is what a cache loads at a time. So whoever
/// needs a neighbour waits for one line of the cache, not for six arrays.
struct alignas(64) BallRecord {
  double x, y, z;       // m
  double vx, vy, vz;    // m/s
  double mass, radius;  // kg, m
};

/// Where a ball lies in memory changes whenever they are sorted: its *slot*. Its *number* is the
/// user's, and stays.
using Slot = std::uint32_t;

/// Slots are taken in groups of eight, the width of the widest vector unit (AVX-512).
inline constexpr Slot group = 8;

/// So many rows of the neighbour lists ahead of the one in work, balls are asked for from memory:
/// about the length of a list, so that it is the next group's.
inline constexpr Slot rows_ahead = 12;

/// Fills the empty places in the neighbour lists: too far away for any force, and near enough that
/// no square of a distance overflows.
inline constexpr BallRecord nobody{1e100, 1e100, 1e100, 0, 0, 0, 1, 0};

}  // namespace bounce::many
