#pragma once
#include <Eigen/Core>

#include "08_racket_game/picture/game_view.hpp"
#include "app/camera.hpp"

namespace bounce {

// The things in the picture of the game, one by one.

/// Squares of half a metre that fade with the distance. Lines only: a filled floor would cost more
/// than all the rest of the picture together, where the processor has to draw it.
void draw_floor(Canvas& canvas, const Camera& camera, const Plane& floor,
                const Eigen::Vector3d& centre);

/// The disc is drawn as large as it counts. `glow` from 0 to 1: it was just hit.
void draw_disc(Canvas& canvas, const Camera& camera, const Disc& disc, bool from_front,
               double glow);
void draw_disc_shadow(Canvas& canvas, const Camera& camera, const Disc& disc, double floor);

/// Where the ball will come down to the racket's height: a cross, and a ring that closes.
void draw_landing(Canvas& canvas, const Camera& camera, const Court& court);

/// Where the ball has just been.
void draw_game_trail(Canvas& canvas, const Camera& camera, const Playback& playback);

/// A ball in contact is flattened by its real overlap; its volume stays.
void draw_flattened_ball(Canvas& canvas, const Camera& camera, const Eigen::Vector3d& centre,
                         double radius, const NearestPoint& nearest);

}  // namespace bounce
