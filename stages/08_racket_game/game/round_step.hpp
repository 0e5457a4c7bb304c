#pragma once
#include <algorithm>
#include <cstdint>

#include "08_racket_game/game/round.hpp"

namespace bounce {

// What happens in a step of a round.

/// The racket during the next `dt` seconds: where it begins, and the velocities that bring it to
/// where it ends. The grip moves on.
inline Disc move_racket(const Settings& settings, Round& round, double dt) {
  const Eigen::Vector3d home = settings.racket.disc.centre;
  if (settings.player == PlayerKind::blind) {
    const BlindSwing swing = blind_swing(settings);
    const double before = swing.height(round.clock);
    round.grip.y.position = swing.height(round.clock + dt);
    round.grip.y.velocity = (round.grip.y.position - before) / dt;
    Disc disc = disc_of(settings, round);
    disc.centre = home + Eigen::Vector3d(0, before, 0);
    disc.velocity = {0, round.grip.y.velocity, 0};
    return disc;
  }
  // Between two inputs the aim moves evenly: a hand does, and its samples do not.
  const double share = std::min(1.0, (round.input_age + dt) / rules::input_time);
  Input now = round.to;
  now.x = round.from.x + share * (round.to.x - round.from.x);
  now.z = round.from.z + share * (round.to.z - round.from.z);
  if (settings.on_beat()) {  // in the middle, and level: only the swing is left to do
    now = {home.x(), home.z(), 0, 0, round.to.swing, 0};
  }
  now = assisted(now, view_of(settings, round));
  return follow(round.grip, now, home, disc_radius_of(settings, round),
                swing_speed(gravity_of(settings, round)), dt);
}

/// From now on the player wants this.
inline void take_input(Round& round, const Input& input) {
  round.points.assist = std::max(round.points.assist, input.assist);
  const double share = std::min(1.0, round.input_age / rules::input_time);
  round.from.x += share * (round.to.x - round.from.x);
  round.from.z += share * (round.to.z - round.from.z);
  round.to = input;
  round.input_age = 0;
}

/// A hit was counted, or the ball flies over a top: what that is worth.
inline void count_points(const Settings& settings, Round& round, bool hit, bool at_top) {
  const Eigen::Vector3d home = settings.racket.disc.centre;
  if (hit && settings.mode == Settings::target) {
    const Landing next =
        landing(round.ball, gravity_of(settings, round), home.y() + settings.racket.radius);
    Eigen::Vector3d off = next.place - aim_after(round.score.hits - 1, settings, round);
    off.y() = 0;
    if (next.after != never) round.points.give(points_for_landing(off.norm()), round.clock);
  } else if (hit) {
    round.points.give(1, round.clock);
    round.points.flies = true;
  }
  if (!at_top) return;
  const double top = round.ball.position.y() - settings.racket.radius - home.y();
  if (settings.mode == Settings::keep_up && round.points.flies) {
    round.points.give(bonus_for_top(top), round.clock);
  }
  round.points.flies = false;
  if (settings.on_beat() && top < rules::too_low) round.score.lost = true;
}

/// One step of the game. `move_ball(scene, ball, dt)` is the physics: it moves the ball beside the
/// racket of `scene`, and says how often the two touched.
template <class MoveBall>
void step(const Settings& settings, Round& round, double dt, const MoveBall& move_ball) {
  const Disc disc = move_racket(settings, round, dt);
  ++round.steps;
  round.clock += dt;
  round.input_age += dt;
  if (round.score.lost) return;

  Racket scene = scene_of(settings, round, disc);
  const Eigen::Vector3d before = round.ball.velocity - scene.disc.velocity;
  const double up = round.ball.velocity.y();
  const long long touches = move_ball(scene, round.ball, dt);
  round.side = scene.side;
  round.through = scene.through;

  const NearestPoint nearest = scene.nearest(scene.disc_at(dt), round.ball.position);
  if (touches > 0) {
    round.touches += touches;
    round.touch_speed = std::abs(dot(nearest.direction, before));
    round.touch_clock = round.clock;
    round.touch_place = nearest.point;
  }
  const Eigen::Vector3d home = settings.racket.disc.centre;
  const double above_racket =
      round.ball.position.y() - home.y() - round.grip.y.position - scene.radius;
  const double above_floor =
      round.ball.position.y() - scene.radius - (home.y() - rules::floor_below);
  const bool touching = touches > 0 || nearest.distance < scene.radius;
  const bool hit = round.score.watch(touching, above_racket, above_floor);
  const bool at_top = !touching && up > 0 && round.ball.velocity.y() <= 0;
  if (settings.counts_points()) count_points(settings, round, hit, at_top);
  if (round.score.lost) round.lost_clock = round.clock;
  if (hit && !is_blind(settings) && settings.mode == Settings::keep_up) {
    round.ball.velocity += push(0, 0.12, settings.seed, round.number, round.score.hits);
  }
}

}  // namespace bounce
