#pragma once

namespace bounce {

/// Where the energy went since a run began, or its parameters changed [J]. Keeping the damper's
/// account costs as much as a step, so that only the window does it.
struct EnergyBook {
  bool is_kept = false;
  double before = 0;  // at the start; and what a moving floor gave since
  double lost = 0;    // to the damper since then; 0 while the book is not kept

  void open(double energy) {
    before = energy;
    lost = 0;
  }
};

}  // namespace bounce
