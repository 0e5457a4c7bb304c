#pragma once
#include <optional>

#include "app/playback.hpp"
#include "physics/components.hpp"
#include "physics/forces.hpp"
#include "run/rows.hpp"

namespace bounce {

/// A contact is over in two frames: its largest force stays in sight for a while.
template <class Vector>
struct PeakForce {
  static constexpr double hold = 0.7;  // s
  Vector spring;                       // N
  State<Vector> ball;                  // where that was
  double share;  // of its colour that is left: 1 at the moment itself, then less
};

/// The largest spring force of the last moments, or nothing where there was none. `forces(t, ball)`
/// tells all forces.
template <class Vector, class ForcesOf>
std::optional<PeakForce<Vector>> peak_force(const Playback& playback, const ForcesOf& forces) {
  std::optional<PeakForce<Vector>> peak;
  const double now = playback.shown_time(), hold = PeakForce<Vector>::hold;
  for (auto point = playback.trace().rbegin(); point != playback.trace().rend(); ++point) {
    if (now - point->t > hold) break;
    if (point->t > now) continue;
    const State<Vector> ball = state_in<Vector>(point->values);
    const Vector spring = forces(point->t, ball).spring;
    if (dot(spring, spring) <= (peak ? dot(peak->spring, peak->spring) : 0)) continue;
    peak = {spring, ball, 1 - (now - point->t) / hold};
  }
  return peak;
}

}  // namespace bounce
