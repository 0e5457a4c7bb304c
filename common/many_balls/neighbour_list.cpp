#include "many_balls/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "physics/text.hpp"

namespace bounce::many {
namespace {

/// Balls of so many neighbouring slots are put in order by the length of their lists.
constexpr std::size_t window = 64;

/// A column of three cells rarely holds more.
constexpr std::size_t padding = 8;

/// So many may be listed however few the balls are: 160 MB. Balls that do not overlap have some 20
/// each, and the 1e5 of a crowd in one place would have 1e10, and 40 GB.
constexpr std::size_t most_in_a_crowd = 40000000;

}  // namespace

void NeighbourList::build(std::vector<BallRecord>& records, std::vector<BallRecord>& scratch,
                          std::vector<int>& number, double skin, Team& team) {
  const std::size_t count = number.size();
  const auto pieces = static_cast<std::size_t>(team.size() == 1 ? 1 : 8 * team.size());
  const std::size_t groups = (count + group - 1) / group;
  length_.resize(count);
  new_length_.resize(count);
  new_number_.resize(count);
  places_.resize(count);
  row_.resize(groups + pieces);
  shares_.resize(pieces);
  for (std::size_t k = 0; k < pieces; ++k) {
    const auto slot = [&](std::size_t part) {
      return static_cast<Slot>(std::min(count, groups * part / pieces * group));
    };
    shares_[k].first = slot(k);
    shares_[k].last = slot(k + 1);
  }
  choose_cells(records, skin);
  sort_by_cell(records, number);
  const std::size_t windows = (count + window - 1) / window;
  team.share_out(shares(), [&](int share) {
    const auto begin_of = [&](std::size_t part) {
      return std::min(count, windows * part / pieces * window);
    };
    const auto part = static_cast<std::size_t>(share);
    order_alike(records, scratch, begin_of(part), begin_of(part + 1));
  });
  scratch.swap(records);
  number.swap(new_number_);
  length_.swap(new_length_);
  std::atomic<std::size_t> listed{0};
  const std::size_t most = std::max<std::size_t>(most_in_a_crowd, 64 * count);
  team.share_out(shares(), [&](int share) {
    find_neighbours(records, shares_[static_cast<std::size_t>(share)], listed, most);
  });
  if (listed.load() > most) {
    throw BadInput("the balls come so close together that more than " + std::to_string(most) +
                   " neighbours would be listed, which is not allowed: spread them out, or take "
                   "fewer");
  }
}

std::size_t NeighbourList::bytes() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  std::size_t sum =
      of(begin_) + of(places_) + of(length_) + of(new_length_) + of(new_number_) + of(row_);
  for (const Share& share : shares_) sum += of(share.neighbours) + of(share.found);
  return sum;
}

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

/// Eight balls go through their lists side by side, and the longest list counts. So among a few
/// dozen neighbours those with equally long lists are put together; how long they are is known from
/// the last time.
void NeighbourList::order_alike(const std::vector<BallRecord>& records,
                                std::vector<BallRecord>& sorted, std::size_t first,
                                std::size_t last) {
  std::array<std::uint16_t, 257> next;
  for (std::size_t from = first; from < last; from += window) {
    const std::size_t to = std::min(last, from + window);
    next.fill(0);
    for (std::size_t i = from; i < to; ++i) ++next[length_[places_[i].slot] + std::size_t{1}];
    for (std::size_t length = 1; length < next.size(); ++length) next[length] += next[length - 1];
    for (std::size_t i = from; i < to; ++i) {
      Place& place = places_[i];
      const std::uint8_t length = length_[place.slot];
      const std::size_t slot = from + next[length]++;
      sorted[slot] = records[place.slot];
      new_number_[slot] = place.number;
      new_length_[slot] = length;
      place.slot = static_cast<Slot>(slot);
    }
  }
}

void NeighbourList::find_neighbours(const std::vector<BallRecord>& records, Share& share,
                                    std::atomic<std::size_t>& listed, std::size_t most) {
  const auto number = static_cast<std::size_t>(&share - shares_.data());
  const auto nobody_slot = static_cast<Slot>(places_.size());
  share.neighbours.clear();
  for (Slot first = share.first; first < share.last; first += group) {
    row_[first / group + number] = static_cast<Slot>(share.neighbours.size() / group);
    std::array<std::size_t, group + 1> begin{};  // of each ball's list in share.found
    std::size_t longest = 0;
    for (Slot lane = 0; lane < group; ++lane) {
      begin[lane + 1] = begin[lane];
      if (first + lane >= share.last) continue;
      begin[lane + 1] = find_neighbours_of(records, first + lane, share, begin[lane]);
      const std::size_t length = begin[lane + 1] - begin[lane];
      length_[first + lane] = static_cast<std::uint8_t>(std::min<std::size_t>(length, 255));
      longest = std::max(longest, length);
    }
    if (listed.fetch_add(longest * group, std::memory_order_relaxed) > most)
      return;  // build throws
    for (std::size_t row = 0; row < longest; ++row) {
      for (Slot lane = 0; lane < group; ++lane) {
        const std::size_t at = begin[lane] + row;
        const bool is_there = at < begin[lane + 1];
        share.neighbours.push_back(is_there ? static_cast<Slot>(share.found[at]) : nobody_slot);
      }
    }
  }
  row_[(share.last + group - 1) / group + number] =
      static_cast<Slot>(share.neighbours.size() / group);
  share.neighbours.insert(share.neighbours.end(), rows_ahead * group, nobody_slot);
}

/// The slots in the order of the numbers. For so few it is quicker to count for each how many come
/// before it, without a branch, than to sort.
void NeighbourList::sort_by_number(Neighbour* near, std::size_t count, Slot* sorted) {
  constexpr std::size_t few = 64;
  if (count > few) {
    std::sort(near, near + count,
              [](const Neighbour& a, const Neighbour& b) { return a.number < b.number; });
    for (std::size_t i = 0; i < count; ++i) sorted[i] = near[i].slot;
    return;
  }
  alignas(64) std::array<int, few> number;
  const std::size_t rounded_up = (count + 7) / 8 * 8;
  for (std::size_t i = 0; i < rounded_up; ++i) {
    number[i] = i < count ? near[i].number : std::numeric_limits<int>::max();
  }
  for (std::size_t i = 0; i < count; ++i) {
    int before = 0;
    for (std::size_t eight = 0; eight < rounded_up; eight += 8) {
      for (std::size_t j = 0; j < 8; ++j) before += number[eight + j] < number[i] ? 1 : 0;
    }
    sorted[before] = near[i].slot;
  }
}

/// Appends to share.found from `found` on; returns where the list ends.
std::size_t NeighbourList::find_neighbours_of(const std::vector<BallRecord>& records, Slot slot,
                                              Share& share, std::size_t found) {
  const std::size_t candidates = find_candidates(records[slot], share);
  if (share.found.size() < found + candidates) share.found.resize(2 * (found + candidates));
  if (share.near.size() < candidates + padding) share.near.resize(2 * candidates + padding);

  const BallRecord& ball = records[slot];
  const double reach = 2 * largest_radius_ + skin_;
  std::size_t near = 0;
  for (std::size_t i = 0; i < candidates; ++i) {
    const Place& other = places_[share.candidates[i]];
    const double x = other.x - ball.x, y = other.y - ball.y, z = other.z - ball.z;
    const double limit = equal_radii_ ? reach : ball.radius + records[other.slot].radius + skin_;
    // Written down in any case, and kept if it is near: quicker than a branch that nobody can
    // predict.
    share.near[near] = {other.number, other.slot};
    const bool is_near = x * x + y * y + z * z <= limit * limit && other.slot != slot;
    near += is_near ? 1 : 0;
  }
  sort_by_number(share.near.data(), near, &share.found[found]);
  return found + near;
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
