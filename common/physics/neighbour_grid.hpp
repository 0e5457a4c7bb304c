#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/text.hpp"

namespace bounce {

/// Two balls by their numbers; `first` is the lower one.
struct BallPair {
  int first;
  int second;
  friend bool operator==(const BallPair&, const BallPair&) = default;
};

/// Finds the pairs of balls that are close enough to touch, without looking at all pairs: space is
/// cut into cubes as wide as the largest ball, and whoever touches a ball is in its own cube or in
/// one of the 26 around it. The work grows with the number of balls, not with its square.
///
/// The pairs come in the order of the double loop `for i, for j > i`. So a sum over them adds the
/// same forces in the same order, and is the same to the last bit.
///
/// There is no box around the world. The balls are sorted by cube, x fastest, then y, then z: the
/// three cubes side by side along x are then neighbours in the list too, and a ball has to look at
/// five stretches of it (its own row, and the four rows around it that come later; those that come
/// earlier look at it). Where one ball is much larger than the others, many small ones share a
/// cube: still right, but slower.
class NeighbourGrid {
 public:
  NeighbourGrid() = default;
  // What is kept between two calls is memory, not knowledge: a copy starts without.
  NeighbourGrid(const NeighbourGrid& /*other*/) {}
  NeighbourGrid& operator=(const NeighbourGrid& /*other*/) { return *this; }

  /// All pairs whose distance is at most the sum of their radii (and, for rounding, pairs that are
  /// a hair further apart). The list holds until the next call. Throws BadInput when there are more
  /// than `most_pairs`: 1e5 balls in one place would be 5e9, and 40 GB.
  static constexpr std::size_t most_pairs = 20000000;
  const std::vector<BallPair>& pairs(const Eigen::Matrix3Xd& position,
                                     const Eigen::VectorXd& radius) {
    sort_by_cube(position, radius);
    find_pairs(position, radius);
    order_pairs(static_cast<std::size_t>(position.cols()));
    return pairs_;
  }

 private:
  // A cube's place in the order: 21 bits each for z, y and x. A step of one along an axis:
  static constexpr std::int64_t step_y = std::int64_t{1} << 21, step_z = std::int64_t{1} << 42;

  struct Entry {
    std::int64_t cube;
    int ball;
  };

  /// The number of a cube along one axis. A million cubes away from the middle all share the last
  /// one (right, but slow), and a coordinate that is no number goes to the middle.
  static std::int64_t number_of(double distance, double width) {
    constexpr double middle = 1 << 20;
    const double number = middle + std::floor(distance / width);
    return static_cast<std::int64_t>(std::isnan(number) ? middle
                                                        : std::clamp(number, 1.0, 2 * middle - 2));
  }

  void sort_by_cube(const Eigen::Matrix3Xd& position, const Eigen::VectorXd& radius) {
    const auto count = static_cast<std::size_t>(position.cols());
    if (entries_.size() != count) {
      entries_.resize(count);
      for (std::size_t i = 0; i < count; ++i) entries_[i].ball = static_cast<int>(i);
      found_.reserve(8 * count);  // equal balls have at most 12 neighbours each, 6 pairs a ball
      pairs_.reserve(8 * count);
      first_pair_.resize(count + 1);
    }
    if (count == 0) return;
    // A little wider than two radii, so that no rounding separates a touching pair.
    const double width = 2.001 * radius.maxCoeff();
    Eigen::Vector3d middle = position.rowwise().mean();
    if (!middle.allFinite()) middle.setZero();
    for (Entry& entry : entries_) {
      const Eigen::Vector3d from_middle = position.col(entry.ball) - middle;
      entry.cube = number_of(from_middle.x(), width) + step_y * number_of(from_middle.y(), width) +
                   step_z * number_of(from_middle.z(), width);
    }
    // The order of the last step, in which little has changed since: quickly sorted.
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.cube < b.cube; });
  }

  void find_pairs(const Eigen::Matrix3Xd& position, const Eigen::VectorXd& radius) {
    found_.clear();
    const auto add_if_close = [&](int i, int j) {
      const double touch = radius[i] + radius[j];
      const double distance_squared = (position.col(i) - position.col(j)).squaredNorm();
      if (distance_squared > touch * touch * (1 + 1e-12)) return;
      if (found_.size() == most_pairs) {
        throw BadInput("the balls overlap in more than " + std::to_string(most_pairs) +
                       " pairs, which is not allowed: spread them out, or take fewer");
      }
      found_.push_back({std::min(i, j), std::max(i, j)});
    };
    // Where the three cubes of each later row begin in the list: as we go on, so do they.
    constexpr std::array<std::int64_t, 4> rows{step_y, step_z - step_y, step_z, step_z + step_y};
    std::array<std::size_t, 4> begin{};
    const std::size_t count = entries_.size();
    for (std::size_t n = 0; n < count; ++n) {
      const auto [cube, ball] = entries_[n];
      for (std::size_t m = n + 1; m < count && entries_[m].cube <= cube + 1; ++m) {
        add_if_close(ball, entries_[m].ball);
      }
      for (std::size_t row = 0; row < rows.size(); ++row) {
        std::size_t& m = begin[row];
        while (m < count && entries_[m].cube < cube + rows[row] - 1) ++m;
        for (std::size_t k = m; k < count && entries_[k].cube <= cube + rows[row] + 1; ++k) {
          add_if_close(ball, entries_[k].ball);
        }
      }
    }
  }

  /// From the order in which they were found to that of the double loop: a counting sort by the
  /// first ball, then the few pairs of each by the second.
  void order_pairs(std::size_t count) {
    std::fill(first_pair_.begin(), first_pair_.end(), 0);
    for (const BallPair& pair : found_) ++first_pair_[static_cast<std::size_t>(pair.first)];
    std::ptrdiff_t end = 0;
    for (std::ptrdiff_t& first : first_pair_) end += first, first = end;
    pairs_.resize(found_.size());
    for (const BallPair& pair : found_) {
      pairs_[static_cast<std::size_t>(--first_pair_[static_cast<std::size_t>(pair.first)])] = pair;
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::sort(pairs_.begin() + first_pair_[i], pairs_.begin() + first_pair_[i + 1],
                [](const BallPair& a, const BallPair& b) { return a.second < b.second; });
    }
  }

  std::vector<Entry> entries_;              // all balls, sorted by cube
  std::vector<BallPair> found_;             // as they were found
  std::vector<BallPair> pairs_;             // in order
  std::vector<std::ptrdiff_t> first_pair_;  // where the pairs of each ball begin
};

}  // namespace bounce
