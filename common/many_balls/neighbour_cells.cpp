// The cells of the neighbour list: which ball is in which, and who is in those around it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "many_balls/neighbour_list.hpp"

namespace bounce::many {

/// The number of a cell along each axis. Beyond a thousand million cells all share the last one
/// (right, but slow), and a coordinate that is no number goes to the middle.
NeighbourList::Cell NeighbourList::cell_of(double x, double y, double z) const {
  const auto number = [this](double distance) -> std::int64_t {
    constexpr double last = 1e9;
    const double cell = distance * cells_per_metre_;
    if (!(std::abs(cell) < last)) return cell > 0 ? 1000000000 : cell < 0 ? -1000000000 : 0;
    const auto towards_zero = static_cast<std::int64_t>(cell);
    return towards_zero - (cell < static_cast<double>(towards_zero) ? 1 : 0);
  };
  return {number(x), number(y), number(z)};
}

/// There is no box around the world: cells far apart share a place, as on a torus, and the distance
/// tells their balls apart. One side has at least three, so that a cell and its two neighbours are
/// three.
NeighbourList::Cell NeighbourList::on_torus(const Cell& cell) const {
  Cell wrapped;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wrapped[axis] = cell[axis] - low_[axis];
    if (wrapped[axis] >= dimensions_[axis]) wrapped[axis] %= dimensions_[axis];
  }
  return wrapped;
}

std::size_t NeighbourList::index_of(const BallRecord& ball) const {
  const Cell cell = on_torus(cell_of(ball.x, ball.y, ball.z));
  return static_cast<std::size_t>((cell[0] * dimensions_[2] + cell[2]) * dimensions_[1] + cell[1]);
}

void NeighbourList::choose_cells(const std::vector<BallRecord>& records, double skin) {
  skin_ = skin;
  largest_radius_ = 0;
  equal_radii_ = true;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    largest_radius_ = std::max(largest_radius_, records[i].radius);
    equal_radii_ = equal_radii_ && records[i].radius == records[0].radius;
  }
  // A little wider than what may touch soon, so that no rounding separates such a pair.
  cells_per_metre_ = 1 / (1.0005 * (2 * largest_radius_ + skin));
  Cell high;
  low_.fill(std::numeric_limits<std::int64_t>::max());
  high.fill(std::numeric_limits<std::int64_t>::min());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Cell cell = cell_of(records[i].x, records[i].y, records[i].z);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], cell[axis]);
      high[axis] = std::max(high[axis], cell[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    dimensions_[axis] = std::max<std::int64_t>(3, high[axis] - low_[axis] + 1);
  }
  // Not many more cells than balls, also when a few balls are far away.
  const auto number = [this] {
    return static_cast<double>(dimensions_[0]) * static_cast<double>(dimensions_[1]) *
           static_cast<double>(dimensions_[2]);
  };
  while (number() > 4 * static_cast<double>(places_.size()) + 64) {
    std::int64_t& largest = *std::max_element(dimensions_.begin(), dimensions_.end());
    largest = std::max<std::int64_t>(3, largest / 2);
  }
}

/// A counting sort: count the balls of each cell, and then every ball knows its place.
void NeighbourList::sort_by_cell(const std::vector<BallRecord>& records,
                                 const std::vector<int>& number) {
  const auto cells = static_cast<std::size_t>(dimensions_[0] * dimensions_[1] * dimensions_[2]);
  begin_.assign(cells + 2, 0);
  for (std::size_t i = 0; i < places_.size(); ++i) ++begin_[index_of(records[i]) + 2];
  for (std::size_t cell = 2; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  // Now begin_[cell + 1] is where the balls of `cell` begin; as they are put there, it moves on to
  // where they end, which is where those of the next one begin.
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const BallRecord& ball = records[i];
    places_[begin_[index_of(ball) + 1]++] = {ball.x, ball.y, ball.z, static_cast<Slot>(i),
                                             number[i]};
  }
}

/// All balls in the cell of this one and in the 26 around it, as numbers of places. Returns how
/// many.
std::size_t NeighbourList::find_candidates(const BallRecord& ball, Share& share) const {
  const Cell cell = on_torus(cell_of(ball.x, ball.y, ball.z));
  const auto wrapped = [&](std::int64_t at, std::size_t axis) {
    return at < 0 ? at + dimensions_[axis] : at < dimensions_[axis] ? at : at - dimensions_[axis];
  };
  std::size_t found = 0;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    if (share.candidates.size() < found + (to - from) + padding) {
      share.candidates.resize(2 * (found + (to - from)) + padding);
    }
    std::uint32_t* out = share.candidates.data() + found;
    for (std::uint32_t i = 0; i < padding; ++i) out[i] = from + i;
    for (std::uint32_t i = padding; i < to - from; ++i) out[i] = from + i;
    found += to - from;
  };
  const std::int64_t y = cell[1], ny = dimensions_[1];
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dz = -1; dz <= 1; ++dz) {
      const std::int64_t x = wrapped(cell[0] + dx, 0), z = wrapped(cell[2] + dz, 2);
      // Three cells one above the other lie one after the other, except at the torus's seam.
      const std::uint32_t* column =
          &begin_[static_cast<std::size_t>((x * dimensions_[2] + z) * ny)];
      add(column[std::max<std::int64_t>(0, y - 1)], column[std::min(y + 1, ny - 1) + 1]);
      if (y == 0) add(column[ny - 1], column[ny]);
      if (y == ny - 1) add(column[0], column[1]);
    }
  }
  return found;
}

}  // namespace bounce::many
