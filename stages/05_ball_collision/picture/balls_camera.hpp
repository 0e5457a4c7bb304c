#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "05_ball_collision/run/balls_world.hpp"
#include "app/camera.hpp"
#include "app/demo.hpp"

namespace bounce {

// Where the camera of stage 5 stands, and how its pictures read the rows of the trace.

inline const BallsRun& balls_of(const Playback& playback) {
  return run_as<BallsRun>(playback.simulation());
}

/// Of one ball in the rows of one time [m], [m/s].
inline Eigen::Vector3d position(const std::vector<double>& rows, std::size_t ball) {
  return {rows[7 * ball + 1], rows[7 * ball + 2], rows[7 * ball + 3]};
}
inline Eigen::Vector3d velocity(const std::vector<double>& rows, std::size_t ball) {
  return {rows[7 * ball + 4], rows[7 * ball + 5], rows[7 * ball + 6]};
}

/// What the camera looks at, and how much of it fits into the picture [m].
struct Framing {
  Eigen::Vector3d centre;
  double size;
  double steepness = 0.30;  // how far from above
};

Framing framing_of(const BallsRun& balls);

Camera camera_for(const Playback& playback, const View& view);

}  // namespace bounce
