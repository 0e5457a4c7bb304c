#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bounce {

/// Two balls by their numbers; `first` is the lower one.
struct BallPair {
  int first;
  int second;
  friend bool operator==(const BallPair&, const BallPair&) = default;
};

/// Finds the pairs of balls that are close enough to touch, without looking at all pairs: space is
/// cut into cubes as wide as the largest ball, and who touches a ball is in its own cube or in one
/// of the 26 around it. The work grows with the number of balls, not with its square.
///
/// The pairs come in the order of the double loop `for i, for j > i`. So a sum over them adds the
/// same forces in the same order, and is the same to the last bit.
///
/// There is no box around the world: cubes that hold a ball are kept in a hash table, so balls may
/// be anywhere. Where one ball is much larger than the others, many small ones share a cube: still
/// right, but slower.
class NeighbourGrid {
 public:
  NeighbourGrid() = default;
  // What is kept between two calls is memory, not knowledge: a copy starts without.
  NeighbourGrid(const NeighbourGrid& /*other*/) {}
  NeighbourGrid& operator=(const NeighbourGrid& /*other*/) { return *this; }

  /// All pairs whose distance is at most the sum of their radii (and, for rounding, a few pairs
  /// that are a hair further apart). The list holds until the next call.
  const std::vector<BallPair>& pairs(const Eigen::Matrix3Xd& position,
                                     const Eigen::VectorXd& radius) {
    sort_into_cells(position, radius);
    pairs_.clear();
    for (int i = 0; i < static_cast<int>(position.cols()); ++i) {
      const std::size_t first_of_i = pairs_.size();
      collect_partners(i, position, radius);
      std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(first_of_i), pairs_.end(),
                [](const BallPair& a, const BallPair& b) { return a.second < b.second; });
    }
    return pairs_;
  }

 private:
  using Cell = std::array<std::int32_t, 3>;

  /// The cube that holds a coordinate. Beyond 2^30 cubes from the origin all share the last one: a
  /// ball that flew that far is still found, only slower, and what is no number goes to cube 0.
  static std::int32_t cell_of(double coordinate, double width) {
    constexpr double furthest = 1 << 30;
    const double cell = std::floor(coordinate / width);
    return std::isnan(cell) ? 0 : static_cast<std::int32_t>(std::clamp(cell, -furthest, furthest));
  }

  /// The cube's place in the table. Two cubes may share one, so that who looks has to compare.
  std::size_t bucket_of(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell[0]), y = static_cast<std::uint32_t>(cell[1]),
               z = static_cast<std::uint32_t>(cell[2]);
    std::uint32_t hash = x * 73856093u ^ y * 19349663u ^ z * 83492791u;
    hash ^= hash >> 15;
    return hash & (first_in_bucket_.size() - 2);  // the table's size is a power of two, plus one
  }

  /// A counting sort: the balls of bucket b are balls_[first_in_bucket_[b]] and those after it, up
  /// to the first of bucket b + 1, in ascending order.
  void sort_into_cells(const Eigen::Matrix3Xd& position, const Eigen::VectorXd& radius) {
    const auto count = static_cast<std::size_t>(position.cols());
    // A little wider than two radii, so that the rounding of a division separates no touching pair.
    const double width = 2.001 * (count > 0 ? radius.maxCoeff() : 1);
    std::size_t size = 2;
    while (size < 2 * count) size *= 2;
    cells_.resize(count);
    balls_.resize(count);
    pairs_.reserve(8 * count);  // equal balls have at most 12 neighbours each, 6 pairs a ball
    first_in_bucket_.assign(size + 1, 0);

    for (std::size_t i = 0; i < count; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      cells_[i] = {cell_of(position(0, column), width), cell_of(position(1, column), width),
                   cell_of(position(2, column), width)};
      ++first_in_bucket_[bucket_of(cells_[i])];
    }
    int end = 0;
    for (int& first : first_in_bucket_) end += first, first = end;
    for (std::size_t i = count; i-- > 0;) {
      balls_[static_cast<std::size_t>(--first_in_bucket_[bucket_of(cells_[i])])] =
          static_cast<int>(i);
    }
  }

  void collect_partners(int i, const Eigen::Matrix3Xd& position, const Eigen::VectorXd& radius) {
    const Cell& centre = cells_[static_cast<std::size_t>(i)];
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dz = -1; dz <= 1; ++dz) {
          const Cell cell{centre[0] + dx, centre[1] + dy, centre[2] + dz};
          const std::size_t bucket = bucket_of(cell);
          for (int n = first_in_bucket_[bucket]; n < first_in_bucket_[bucket + 1]; ++n) {
            const int j = balls_[static_cast<std::size_t>(n)];
            if (j <= i || cells_[static_cast<std::size_t>(j)] != cell) continue;
            const double touch = radius[i] + radius[j];
            const double distance_squared = (position.col(i) - position.col(j)).squaredNorm();
            if (distance_squared <= touch * touch * (1 + 1e-12)) pairs_.push_back({i, j});
          }
        }
      }
    }
  }

  std::vector<Cell> cells_;           // of each ball
  std::vector<int> first_in_bucket_;  // where a bucket begins in balls_
  std::vector<int> balls_;            // all balls, bucket by bucket
  std::vector<BallPair> pairs_;
};

}  // namespace bounce
