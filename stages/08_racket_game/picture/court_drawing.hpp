#pragma once
#include <Eigen/Core>
#include <span>

#include "08_racket_game/game/loss.hpp"
#include "app/camera.hpp"
#include "app/canvas.hpp"

namespace bounce {

/// What the picture needs to know, of the game or of the bare physics.
struct Court {
  State<Eigen::Vector3d> ball;
  Racket racket;                  // as it is now, with the gravity of now
  Eigen::Vector3d home{0, 0, 0};  // where the racket began
  const GameRun* game = nullptr;  // nullptr: the bare physics
};
Court court_of(const Simulation& simulation);

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

/// What counts, by the mode: the band of tops, or the ring where the ball shall land.
void draw_goal(Canvas& canvas, const Camera& camera, const Court& court);

/// Blind: a hand that goes round once a beat, and is at the top when it is time to swing. `flash`
/// from 0 to 1: the beat has just been.
void draw_beat(Canvas& canvas, Point centre, double phase, double flash);

/// Where the ball has just been, the latest place first.
struct TrailPoint {
  double age;  // s
  Eigen::Vector3d place;
};
void draw_game_trail(Canvas& canvas, const Camera& camera, std::span<const TrailPoint> trail);
inline constexpr double trail_lasts = 0.35;  // s

/// What is seen when a loss is shown again: the ball's velocity, where it was touched last, and
/// the racket's push there.
void draw_arrows(Canvas& canvas, const Camera& camera, const Court& court, const Moment& now,
                 const Moment* touch);

/// A ball in contact is flattened by its real overlap; its volume stays.
void draw_flattened_ball(Canvas& canvas, const Camera& camera, const Eigen::Vector3d& centre,
                         double radius, const NearestPoint& nearest);

}  // namespace bounce
