#pragma once
#include "08_racket_game/game/loss.hpp"
#include "08_racket_game/picture/court_drawing.hpp"

namespace bounce {

// What is no thing in the court, but says something about it.

/// Where the ball will come down to the racket's height: a cross, and a ring that closes.
void draw_landing(Canvas& canvas, const Camera& camera, const Court& court);

/// What counts, by the mode: the band of tops, or the ring where the ball shall land.
void draw_goal(Canvas& canvas, const Camera& camera, const Court& court);

/// Blind: a hand that goes round once a beat, and is at the top when it is time to swing. `flash`
/// from 0 to 1: the beat has just been.
void draw_beat(Canvas& canvas, Point centre, double phase, double flash);

/// What is seen when a loss is shown again: the ball's velocity, where it was touched last and the
/// racket's push there, and how far beside the racket the ball is.
void draw_arrows(Canvas& canvas, const Camera& camera, const Court& court, const Moment& now,
                 const Moment* touch);

}  // namespace bounce
