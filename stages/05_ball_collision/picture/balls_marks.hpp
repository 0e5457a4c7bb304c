#pragma once
#include <vector>

#include "05_ball_collision/picture/balls_camera.hpp"

namespace bounce {

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
