#pragma once
#include "app/camera.hpp"
#include "app/space_view.hpp"

namespace bounce {

/// The arrows of the view in space: weight, spring, damper and velocity.
void draw_forces(Canvas& canvas, const Camera& camera, const Playback& playback, const View& view,
                 const BallInSpace& ball);

}  // namespace bounce
