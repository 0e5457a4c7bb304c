#include "many_balls/neighbour_list.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "physics/text.hpp"

namespace bounce::many {
namespace {

/// Balls of so many neighbouring slots are put in order by the length of their lists.
constexpr std::size_t window = 64;

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

}  // namespace bounce::many
