#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "08_racket_game/game/game.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/state.hpp"

namespace bounce {

enum class PlayerKind { human, autopilot, blind, idle };
/// As `--player` calls them. The last is the bare physics, without the game.
inline const std::vector<std::string> player_names{"human", "autopilot", "blind", "idle", "none"};

/// What a player sees.
struct PlayerView {
  State<Eigen::Vector3d> ball;
  double ball_radius;    // m
  double gravity;        // m/s^2
  double restitution;    // of ball and racket
  Eigen::Vector3d home;  // the middle of the court, at the height of the lowered racket
  Eigen::Vector3d aim;   // where the next hit shall send the ball: there, or to a target
};

/// Where and when the falling ball will be at that height, from the closed form.
struct Landing {
  double after = never;  // s; `never` when it is below already
  Eigen::Vector3d place{0, 0, 0};
  double speed = 0;  // downwards [m/s]
};

inline Landing landing(const State<Eigen::Vector3d>& ball, double gravity, double height) {
  const double above = ball.position.y() - height;
  if (above < 0 && ball.velocity.y() * ball.velocity.y() + 2 * gravity * above < 0) return {};
  const double up = ball.velocity.y();
  const double speed = std::sqrt(std::max(0.0, up * up + 2 * gravity * above));
  const double after = gravity > 0 ? (up + speed) / gravity : (up < 0 ? -above / up : never);
  if (!(after >= 0) || after == never) return {};
  Eigen::Vector3d place = ball.position + ball.velocity * after;
  place.y() = height;
  return {after, place, speed};
}

/// The autopilot has the player's means and no others. It goes where the ball will land, tilts the
/// racket so that the ball comes to its aim, mostly the middle of the court, and swings at the
/// right moment.
inline Input autopilot(const PlayerView& view) {
  const double swing = swing_speed(view.gravity);
  const double meeting = view.home.y() + view.ball_radius + rules::stroke / 2;
  const Landing next = landing(view.ball, view.gravity, meeting);
  Input input;
  if (next.after == never) {  // it is low: stay below it, and lift it
    input.x = view.ball.position.x();
    input.z = view.ball.position.z();
    input.swing = 1;
    return input;
  }
  input.x = next.place.x();
  input.z = next.place.z();

  // A racket that leans by a small angle a, and meets the ball with the speed w, changes the ball's
  // velocity along the ground by (1 + e) w a. The flight that follows lasts T.
  const double e = view.restitution, w = next.speed + swing;
  const double T = 2 * (e * w + swing) / view.gravity;
  const auto tilt = [&](double place, double middle, double velocity) {
    const double wanted = (middle - place) / T;
    return std::clamp((wanted - velocity) / ((1 + e) * w) / rules::largest_tilt, -1.0, 1.0);
  };
  input.tilt_x = tilt(next.place.x(), view.aim.x(), view.ball.velocity.x());
  input.tilt_z = tilt(next.place.z(), view.aim.z(), view.ball.velocity.z());

  // Half the stroke before the meeting, and the time to get to speed.
  const double lead = rules::stroke / 2 / swing + 0.02;
  input.swing = next.after < lead ? 1 : 0;
  return input;
}

/// Takes a share of the aim off the player: the place and the lean, never the swing, and never the
/// physics.
inline Input assisted(Input input, const PlayerView& view) {
  const double share = std::clamp(input.assist, 0.0, 1.0);
  if (share == 0) return input;
  const Input aim = autopilot(view);
  input.x += share * (aim.x - input.x);
  input.z += share * (aim.z - input.z);
  input.tilt_x += share * aim.tilt_x;
  input.tilt_z += share * aim.tilt_z;
  return input;
}

/// The blind player moves the racket as a sine and never looks: y = A sin(w t + phase).
struct BlindSwing {
  double frequency = 1.107;  // Hz
  double amplitude = 0.122;  // m
  double phase = 0;
  double top = 0;  // where the ball is at the start, at the top of its flight: its underside above
                   // the middle of the sine [m]

  double angular_frequency() const { return 2 * std::numbers::pi * frequency; }
  double height(double t) const { return amplitude * std::sin(angular_frequency() * t + phase); }

  /// A ball that comes back once a period, and spends the time `contact` in the racket, leaves with
  /// the speed v = g (T - contact) / 2.
  double speed(double gravity, double contact) const {
    return gravity * (1 / frequency - contact) / 2;
  }
  /// The racket gives back what the bounce takes where its own speed is v (1 - e) / (1 + e): at two
  /// phases of its sine, on the way up while it slows down (> 0), or while it speeds up (< 0).
  double hit_phase(double speed, double restitution, bool slowing) const {
    const double u = speed * (1 - restitution) / (1 + restitution);
    const double hit = std::acos(std::min(1.0, u / (amplitude * angular_frequency())));
    return slowing ? hit : -hit;
  }
};

}  // namespace bounce
