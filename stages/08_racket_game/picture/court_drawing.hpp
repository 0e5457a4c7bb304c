#pragma once
#include <span>
#include <vector>

#include "08_racket_game/game/game_run.hpp"
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

/// The one colour that says: here, now. All else is grey, but for arrows, whose colours are those
/// of all stages.
inline constexpr Colour accent{0xD5, 0x5E, 0x00};

/// A circle in space, around `centre`, square to `normal`.
std::vector<Eigen::Vector3d> circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                                    double radius, int corners = 64);

// The things in the picture of the game, one by one.

/// The sky down to the horizon. The ground is the paper: to fill it would cost more than all the
/// rest of the picture together, where the processor has to draw it.
void draw_sky(Canvas& canvas, const Camera& camera, Rect area, double floor);

/// Squares of half a metre, and of two, that fade with the distance.
void draw_floor(Canvas& canvas, const Camera& camera, double floor, const Eigen::Vector3d& centre);

/// The disc is drawn as large as it counts. `glow` from 0 to 1: it was just hit.
void draw_disc(Canvas& canvas, const Camera& camera, const Disc& disc, bool from_front,
               double glow);
void draw_disc_shadow(Canvas& canvas, const Camera& camera, const Disc& disc, double floor);

/// Where the ball has just been, the latest place first.
struct TrailPoint {
  double age;  // s
  Eigen::Vector3d place;
};
void draw_game_trail(Canvas& canvas, const Camera& camera, std::span<const TrailPoint> trail);
inline constexpr double trail_lasts = 0.35;  // s

/// A ball in contact is flattened by its real overlap; its volume stays.
void draw_flattened_ball(Canvas& canvas, const Camera& camera, const Eigen::Vector3d& centre,
                         double radius, const NearestPoint& nearest);

}  // namespace bounce
