#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "many_balls/ball_record.hpp"
#include "many_balls/team.hpp"

namespace bounce::many {

/// Balls sorted by place, and for each the others that may soon touch it, in two lists. The long
/// one has all whose surfaces are nearer than a thick *skin*, and costs a search through cells. The
/// short one is taken from it in passing, with a thin skin. As long as no ball has moved further
/// than half a skin, its list holds. (Two lists, as in Pall et al.,
/// "Heterogeneous parallelization and acceleration of molecular dynamics simulations in GROMACS",
/// 2020.)
///
/// Each ball lists all its neighbours, so that every pair stands in two lists. This is twice the
/// work, and worth it: a force is only ever added to the ball that asks for it. So eight balls can
/// be done side by side and many threads can share the work, and the sum for each ball has the
/// order of the double loop: by the neighbours' numbers.
class NeighbourList {
 public:
  /// Sorts `records` (and `number`, where whose number it is stands) and finds all neighbours
  /// within `skin` [m]. `scratch` is as large as `records`; they may trade places. Throws BadInput
  /// when the balls crowd together so much that the lists would not fit into memory.
  void build(std::vector<BallRecord>& records, std::vector<BallRecord>& scratch,
             std::vector<int>& number, double skin, Team& team);

  /// Takes from the long lists those that are within `skin` [m] now.
  void shorten(const std::vector<BallRecord>& records, double skin, Team& team);

  std::size_t bytes() const;  // of memory

  /// The balls are divided into shares, a few for each member of the team.
  int shares() const { return static_cast<int>(shares_.size()); }
  /// The slots of one share: from the first to before the second.
  std::array<Slot, 2> slots(int share) const { return {of(share).first, of(share).last}; }
  /// For Pass::row and Pass::neighbours, in the slots of that share.
  const Slot* rows(int share) const { return row_.data() + share; }
  const Slot* neighbours(int share) const { return of(share).rows.data(); }

 private:
  /// A ball as the search needs it, sorted by cell.
  struct Place {
    double x, y, z;
    Slot slot;
    int number;
  };
  struct Neighbour {
    int number;
    Slot slot;
  };
  /// A part of the balls, with the lists of its own.
  struct Share {
    Slot first = 0, last = 0;
    std::vector<Slot> long_lists;           // one after the other
    std::vector<std::uint32_t> lengths;     // of them
    std::vector<Slot> rows;                 // the short lists, those of eight balls side by side
    std::vector<std::uint32_t> candidates;  // places
    std::vector<Neighbour> near;
  };
  using Cell = std::array<std::int64_t, 3>;

  /// A column of three cells rarely holds more: so many are copied without asking.
  static constexpr std::size_t padding = 8;

  const Share& of(int share) const { return shares_[static_cast<std::size_t>(share)]; }

  Cell cell_of(double x, double y, double z) const;
  Cell on_torus(const Cell& cell) const;
  std::size_t index_of(const BallRecord& ball) const;
  void choose_cells(const std::vector<BallRecord>& records, double skin);
  void sort_by_cell(const std::vector<BallRecord>& records, const std::vector<int>& number);
  void order_alike(const std::vector<BallRecord>& records, std::vector<BallRecord>& sorted,
                   std::size_t first, std::size_t last);
  void find_neighbours(const std::vector<BallRecord>& records, Share& share,
                       std::atomic<std::size_t>& listed, std::size_t most);
  void shorten(const std::vector<BallRecord>& records, double skin, Share& share);
  static void sort_by_number(Neighbour* near, std::size_t count, Slot* sorted);
  std::size_t find_candidates(const BallRecord& ball, Share& share) const;
  std::size_t find_neighbours_of(const std::vector<BallRecord>& records, Slot slot, Share& share,
                                 std::size_t found);

  double skin_ = 0, cells_per_metre_ = 1, largest_radius_ = 0;
  bool equal_radii_ = true;
  Cell low_{};                        // the first of the cells that are in use
  Cell dimensions_{};                 // of the torus of cells
  std::vector<std::uint32_t> begin_;  // of each cell, in places_
  std::vector<Place> places_;
  std::vector<std::uint8_t> length_;  // of each short list (a very long one counts as 255)
  std::vector<std::uint8_t> new_length_;
  std::vector<int> new_number_;
  // Where each group's rows begin among its share's neighbours; each share has one entry more, the
  // end of its last group's.
  std::vector<Slot> row_;
  std::vector<Share> shares_;
};

}  // namespace bounce::many
