#pragma once
#include <string>

#include "checks/law.hpp"

namespace bounce::check {

/// A whole run against the exact solution: from rest, along the direction in which the floor
/// pushes, until it has bounced once and is in flight again.
struct Run {
  Setting setting;
  Motion start;
  double dt;
  long steps;
  Triple along;      // the direction that is compared
  double exact;      // where the ball is along it at the end [m], by formula
  double tolerance;  // m

  double end() const { return dt * static_cast<double>(steps); }
};

/// Position along `run.along` at the end, by the subject's loop [m].
inline double end_of(const Subject& who, const Run& run) {
  return dot(who.run(run.setting, run.start, run.dt, run.steps).position, run.along);
}

/// One bounce, by formula: `along` is a floor's normal through the origin.
Run bounce_run(const Setting& setting, const Triple& along, double drop, double dt);
/// Stage 5: a ball that runs into one at rest. Stage 6: a floor that swings.
Run pair_run(const Setting& setting, const Triple& along, double speed, double dt);
Run floor_run(const Setting& setting, double drop, double dt);

/// Runs with several settings and steps. Everything in a run has been asked before, so this is the
/// last check of a stage: that the pieces make a ball that bounces as it should.
void judge_runs(const std::string& lesson, const std::vector<Run>& runs);

/// One row of "speed against error".
struct SpeedRow {
  double dt, error, course_error, ns, course_ns;
};
/// The subject beside the course's own stage, in alternation; medians.
std::vector<SpeedRow> speed_against_error(const Subject& mine, const Subject& course,
                                          const std::vector<Run>& runs);

/// Runs for it, for the stage of that number.
std::vector<Run> speed_runs(int stage);

}  // namespace bounce::check
