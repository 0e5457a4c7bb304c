// What would happen from here, with the present parameters.
#include <algorithm>
#include <cmath>

#include "app/playback.hpp"

namespace bounce {

bool Playback::is_at_rest() const {
  const TracePoint& now = trace_.back();
  for (auto point = trace_.rbegin(); point != trace_.rend(); ++point) {
    if (now.t - point->t > 0.5) return true;
    if (point->energy.kinetic > 1e-4 * std::abs(point->before)) return false;
  }
  return false;
}

std::vector<TracePoint> Playback::future(double seconds) const {
  const std::unique_ptr<Simulation> ahead = simulation_->clone();
  double later = 0;
  if (is_at_rest()) {
    later = simulation_->time();
    ahead->restart();
  }
  const double end = ahead->time() + seconds;
  std::vector<TracePoint> points;
  try {
    const bool by_events = ahead->method().goes_by_events;
    const double stride = by_events ? trace_interval : std::max(ahead->dt(), trace_interval);
    // About a millisecond for one ball, and with many not much longer.
    const double most_steps = 2e5 / static_cast<double>(ahead->balls());
    const double reach = by_events ? end : std::min(end, ahead->time() + most_steps * ahead->dt());
    const double begin = wall_clock();
    while (ahead->time() < reach && points.size() < 4000) {
      // How long an event takes, nobody knows before: with many balls `reference` is slow.
      if (by_events && ahead->balls() > 1 && wall_clock() - begin > frame_budget) break;
      points.push_back(trace_point(*ahead));
      points.back().t += later;
      const double whole = std::max(1.0, std::round(stride / ahead->dt()));
      ahead->advance_to(by_events ? ahead->time() + stride
                                  : ahead->time_of_next_step() + (whole - 1) * ahead->dt());
    }
  } catch (const std::exception&) {  // the path ends where the run would
  }
  return points;
}

}  // namespace bounce
