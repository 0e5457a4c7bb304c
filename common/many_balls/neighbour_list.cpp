#include "many_balls/neighbour_list.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "physics/text.hpp"

namespace bounce::many {
namespace {

/// Balls of so many neighbouring slots are put in order by the length of their lists.
constexpr std::size_t window = 512;

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
  for (const Share& share : shares_)
    sum += of(share.long_lists) + of(share.lengths) + of(share.rows);
  return sum;
}

/// Eight balls go through their lists side by side, and the longest list counts. So among a few
/// hundred neighbours those with equally long lists are put together; how long they are is known
/// from the last time.
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
  share.lengths.clear();
  std::size_t found = 0;
  for (Slot slot = share.first; slot < share.last; ++slot) {
    const std::size_t begin = found;
    found = find_neighbours_of(records, slot, share, begin);
    share.lengths.push_back(static_cast<std::uint32_t>(found - begin));
    if (listed.fetch_add(found - begin, std::memory_order_relaxed) > most) return;  // build throws
  }
}

void NeighbourList::shorten(const std::vector<BallRecord>& records, double skin, Team& team) {
  team.share_out(shares(), [&](int share) {
    shorten(records, skin, shares_[static_cast<std::size_t>(share)]);
  });
}

void NeighbourList::shorten(const std::vector<BallRecord>& records, double skin, Share& share) {
  const auto number = static_cast<std::size_t>(&share - shares_.data());
  const auto nobody_slot = static_cast<Slot>(places_.size());
  const double reach = 2 * largest_radius_ + skin;
  const Slot* next = share.long_lists.data();
  std::size_t rows = 0;
  for (Slot first = share.first; first < share.last; first += group) {
    row_[first / group + number] = static_cast<Slot>(rows);
    const Slot balls = std::min(group, share.last - first);
    const std::uint32_t* lengths = &share.lengths[first - share.first];
    const std::size_t most = rows + 1 + *std::max_element(lengths, lengths + balls);
    if (share.rows.size() < most * group) share.rows.resize(2 * most * group);
    std::array<std::size_t, group> end;  // of each ball's list
    end.fill(rows);
    for (Slot lane = 0; lane < balls; ++lane) {
      const BallRecord& ball = records[first + lane];
      for (const Slot* const last = next + lengths[lane]; next != last; ++next) {
        const BallRecord& other = records[*next];
        const double x = other.x - ball.x, y = other.y - ball.y, z = other.z - ball.z;
        const double limit = equal_radii_ ? reach : ball.radius + other.radius + skin;
        // Written down in any case, and kept if it is near, as above.
        share.rows[end[lane] * group + lane] = *next;
        end[lane] += x * x + y * y + z * z <= limit * limit ? 1 : 0;
      }
      length_[first + lane] =
          static_cast<std::uint8_t>(std::min<std::size_t>(end[lane] - rows, 255));
    }
    rows = *std::max_element(end.begin(), end.end());
    for (Slot lane = 0; lane < group; ++lane) {
      for (; end[lane] < rows; ++end[lane]) share.rows[end[lane] * group + lane] = nobody_slot;
    }
  }
  row_[(share.last + group - 1) / group + number] = static_cast<Slot>(rows);
  share.rows.resize(rows * group);
  share.rows.insert(share.rows.end(), rows_ahead * group, nobody_slot);
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

/// Appends to the long lists from `found` on; returns where this one ends.
std::size_t NeighbourList::find_neighbours_of(const std::vector<BallRecord>& records, Slot slot,
                                              Share& share, std::size_t found) {
  const std::size_t candidates = find_candidates(records[slot], share);
  if (share.long_lists.size() < found + candidates) {
    share.long_lists.resize(2 * (found + candidates));
  }
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
  sort_by_number(share.near.data(), near, &share.long_lists[found]);
  return found + near;
}

}  // namespace bounce::many
