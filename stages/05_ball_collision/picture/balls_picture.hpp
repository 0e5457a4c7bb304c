#pragma once

#include "app/demo.hpp"

namespace bounce {

/// Gives the demo its picture: the balls of a BallsRun in perspective, coloured by speed,
/// with floor and tray. A few balls have shadows, trails and numbers too, and can be dragged.
void use_balls_picture(Demo& demo);

}  // namespace bounce
