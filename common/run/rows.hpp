#pragma once
#include <cstddef>
#include <vector>

#include "physics/components.hpp"
#include "physics/state.hpp"

namespace bounce {

// A row of the trace ends with the position's numbers and the velocity's. Many balls have a row
// each, one after the other, that begins with the ball's number.

/// The state in such a row (or rows). `state` has the size that it shall have.
template <class Vector>
void read_rows(const std::vector<double>& rows, State<Vector>& state) {
  const auto position = components(state.position), velocity = components(state.velocity);
  const std::size_t balls = position.size() <= 3 ? 1 : position.size() / 3;
  const std::size_t dimensions = position.size() / balls, width = rows.size() / balls;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const std::size_t row_end = (i / dimensions + 1) * width, at = i % dimensions;
    position[i] = rows.at(row_end - 2 * dimensions + at);
    velocity[i] = rows.at(row_end - dimensions + at);
  }
}

/// For one ball.
template <class Vector>
State<Vector> state_in(const std::vector<double>& row) {
  State<Vector> state;
  read_rows(row, state);
  return state;
}

}  // namespace bounce
