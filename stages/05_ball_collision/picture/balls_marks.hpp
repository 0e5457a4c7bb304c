#pragma once
#include <vector>

#include "05_ball_collision/run/balls_world.hpp"
#include "app/camera.hpp"
#include "app/demo.hpp"

namespace bounce {

inline const BallsRun& balls_of(const Playback& playback) {
  return run_as<BallsRun>(playback.simulation());
}

/// The balls in the rows of one time: a column for each.
using Balls = State<Eigen::Matrix3Xd>;
inline Balls balls_in(const std::vector<double>& rows) {
  const auto count = static_cast<Eigen::Index>(rows.size() / 7);  // ball,x,y,z,vx,vy,vz
  Balls balls{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  read_rows(rows, balls);
  return balls;
}

// What is drawn around a few balls: where they were and will be, and what acts on them.

void draw_trails(Canvas& canvas, const Camera& camera, const Playback& playback,
                 Eigen::Index count);

/// Where the balls will go; with `earlier`, where they would have gone with the setting before.
void draw_futures(Canvas& canvas, const Camera& camera, const std::vector<TracePoint>& future,
                  Eigen::Index count, bool earlier);

/// Where the exact solution has the balls: pale rings.
void draw_ghosts(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const Balls& exact);

/// Velocities, and while balls touch, the force on each of a pair.
void draw_arrows(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const Balls& balls);

/// In rows: the speed under each ball. In the tower: how high the small ball came.
void draw_numbers(Canvas& canvas, const Camera& camera, const Playback& playback,
                  const Balls& balls);

}  // namespace bounce
