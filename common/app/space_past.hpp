#pragma once
#include <Eigen/Core>
#include <vector>

#include "app/camera.hpp"
#include "app/space_view.hpp"

namespace bounce {

// The parts of the view in space that show where the ball has been.

inline Eigen::Vector3d position_in(const std::vector<double>& values) {
  return state_in<Eigen::Vector3d>(values).position;
}

/// The trail fades with age and carries a dot every tenth of a second: even dots, even speed.
void draw_trail(Canvas& canvas, const Camera& camera, const Playback& playback,
                const BallInSpace& ball);

/// Marks where the ball touched, with the way and the time from one mark to the next.
void draw_landings(Canvas& canvas, const Camera& camera, const Playback& playback,
                   const BallInSpace& ball);

}  // namespace bounce
