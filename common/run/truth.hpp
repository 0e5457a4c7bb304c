#pragma once
#include <algorithm>
#include <optional>
#include <utility>

#include "physics/components.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/state.hpp"

namespace bounce {

/// What a run is compared with: a walk from event to event that reaches a time, or gives up.
/// `Walk` has reach(t, most_events), last_event() and at(t).
template <class Walk, class Vector>
class Truth {
 public:
  Truth() = default;  // nothing to compare with
  Truth(Walk walk, long long most_events) : walk_(std::move(walk)), most_events_(most_events) {}

  /// The state at `t` [s], which may lie a little before the last time that was asked for, for a
  /// smooth picture. Nothing where the walk's events no longer advance time, or are too many: a
  /// comparison is worth a second or two, not an hour.
  std::optional<State<Vector>> at(double t) {
    try {
      if (!walk_ || !walk_->reach(t, most_events_)) return std::nullopt;
      State<Vector> state = walk_->at(std::max(t, walk_->last_event()));
      if (is_finite(state.position) && is_finite(state.velocity)) return state;
    } catch (const TimeStandsStill&) {
      walk_.reset();
    }
    return std::nullopt;
  }

 private:
  std::optional<Walk> walk_;
  long long most_events_ = 0;
};

}  // namespace bounce
