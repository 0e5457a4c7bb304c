#pragma once

#include "app/camera.hpp"
#include "app/demo.hpp"

namespace bounce {

/// Gives the demo its picture: the balls of a BallsRun in perspective, coloured by speed,
/// with floor and tray. A few balls have shadows, trails and numbers too, and can be dragged.
void use_balls_picture(Demo& demo);

/// Where the camera of that picture stands.
Camera camera_for(const Playback& playback, const View& view);

}  // namespace bounce
