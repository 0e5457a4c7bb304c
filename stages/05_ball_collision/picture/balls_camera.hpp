#pragma once
#include <vector>

#include "05_ball_collision/run/balls_world.hpp"
#include "app/camera.hpp"
#include "app/demo.hpp"

namespace bounce {

// Where the camera of stage 5 stands, and how its pictures read the rows of the trace.

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

/// What the camera looks at, and how much of it fits into the picture [m].
struct Framing {
  Eigen::Vector3d centre;
  double size;
  double steepness = 0.30;  // how far from above
};

Framing framing_of(const BallsRun& balls);

Camera camera_for(const Playback& playback, const View& view);

}  // namespace bounce
