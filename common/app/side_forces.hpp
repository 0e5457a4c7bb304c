#pragma once
#include "app/side_view.hpp"

namespace bounce {

/// The arrows of the side view: weight, spring, damper and velocity. `centre`, `radius` and
/// `ground` are the ball's and the floor's in the picture [px].
void draw_forces(Canvas& canvas, const Playback& playback, const View& view,
                 const BallOnALine& ball, Point centre, float radius, float ground);

}  // namespace bounce
