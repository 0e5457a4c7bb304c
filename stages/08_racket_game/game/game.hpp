#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "physics/shapes.hpp"

namespace bounce {

// The rules of the game, as plain functions: no window, no clock, no chance that is not asked for.

/// What a player wants, human or not. The racket follows as fast as it can.
struct Input {
  double x = 0, z = 0;            // where the racket shall be [m]
  double tilt_x = 0, tilt_z = 0;  // which way it shall lean: from -1 to 1, times the largest tilt
  double swing = 0;               // 1: up; 0: down
  double assist = 0;              // how much of the aim is taken off the player, from 0 to 1
};
/// All of it, for what notes, reads or keeps inputs; also of one that must not change.
inline auto numbers_of(auto& input) {
  return std::array{&input.x, &input.z, &input.tilt_x, &input.tilt_z, &input.swing, &input.assist};
}

namespace rules {
inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double largest_tilt = 8 * degree;  // sends the ball 1 m aside per metre of fall
inline constexpr double stroke = 0.12;              // m that a swing lifts the racket
inline constexpr double rises = 0.1;                // m above the racket: now a hit counts
inline constexpr double floor_below = 0.7;          // m below the racket: there the ball is lost
inline constexpr double court = 1.2;  // m from its middle to each side: hands reach so far
inline constexpr double input_time = 1.0 / 60;  // s from one input to the next
}  // namespace rules

// ---- Difficulty

/// 2 % smaller with every hit, down to half the first radius [m].
inline double disc_radius_after(int hits, double first) {
  return std::max(first / 2, first * std::pow(0.98, hits));
}

/// Slow at first: 4 m/s^2, and 0.25 more with every hit, up to the scene's gravity.
inline double gravity_after(int hits, double full) { return std::min(full, 4 + 0.25 * hits); }

/// Speed of a swing [m/s]: such that a swing at every hit (restitution 0.8) leads to tops of 1.2 m
/// above the racket, whatever gravity is. With the speed V of a fall from 1 m,
/// v = e v + (1 + e) u gives u = v (1 - e) / (1 + e) = 1.08 V / 9.
inline double swing_speed(double gravity) {
  return std::max(0.05, 0.12 * std::sqrt(2 * gravity * 1.0));
}

// ---- The racket follows

/// Something that moves along a line.
struct Follower {
  double position = 0;  // m, or rad
  double velocity = 0;
};

struct Limits {
  double rate;          // 1/s: how eagerly it follows
  double speed;         // m/s, or rad/s
  double acceleration;  // m/s^2, or rad/s^2
};
inline constexpr Limits sideways{60, 6, 150};  // 95 % of the way in 79 ms, 33 ms behind
inline constexpr Limits tilting{32, 4, 120};   // level again after 150 ms

/// Critically damped: a = w^2 d - 2 w v for a target at distance d. Written as 2 w (w d / 2 - v) it
/// says: get to the velocity w d / 2. That one is capped, by the speed that is allowed and by the
/// one that can still be braked over d, so that the racket does not overshoot.
inline void follow(Follower& it, double target, const Limits& limits, double dt) {
  const double distance = target - it.position;
  const double can_be_braked = std::sqrt(1.6 * limits.acceleration * std::abs(distance));
  const double cap = std::min(limits.speed, can_be_braked);
  const double wanted = std::clamp(limits.rate / 2 * distance, -cap, cap);
  it.velocity += std::clamp(2 * limits.rate * (wanted - it.velocity),  //
                            -limits.acceleration, limits.acceleration) *
                 dt;
  it.position += it.velocity * dt;
}

/// The racket as the player holds it: shifts from its home, and angles of lean.
struct Grip {
  Follower x, y, z;
  Follower lean_x, lean_z;  // rad; the normal leans towards +x, +z

  Eigen::Vector3d shift() const { return {x.position, y.position, z.position}; }
  Eigen::Vector3d normal() const {
    return Eigen::Vector3d(std::tan(lean_x.position), 1, std::tan(lean_z.position)).normalized();
  }
};

/// The grip moves on by one step. Returns the disc as it is at the beginning of the step, with the
/// velocities that bring it to where the grip is at the end.
inline Disc follow(Grip& grip, const Input& input, const Eigen::Vector3d& home, double disc_radius,
                   double swing_speed, double dt) {
  const Eigen::Vector3d before = grip.shift(), normal = grip.normal();
  follow(grip.x, input.x - home.x(), sideways, dt);
  follow(grip.z, input.z - home.z(), sideways, dt);
  const double up = std::clamp(input.swing, 0.0, 1.0) * rules::stroke;
  follow(grip.y, up, {60, swing_speed, 40}, dt);
  const auto lean = [](double tilt) { return std::clamp(tilt, -1.0, 1.0) * rules::largest_tilt; };
  follow(grip.lean_x, lean(input.tilt_x), tilting, dt);
  follow(grip.lean_z, lean(input.tilt_z), tilting, dt);

  Disc disc{home + before, normal, disc_radius, (grip.shift() - before) / dt, {0, 0, 0}};
  const Eigen::Vector3d axis = normal.cross(grip.normal());  // its length: the sine of the angle
  if (const double sine = axis.norm(); sine > 0) {
    disc.angular_velocity = axis * (std::asin(std::min(1.0, sine)) / sine / dt);
  }
  return disc;
}

// ---- Score

struct Score {
  int hits = 0;          // in this round
  int best = 0;          // of all rounds
  bool touched = false;  // and has not risen since
  bool lost = false;     // the round is over

  /// After a step: did the ball touch the racket in it, how high is its underside above the racket,
  /// and how high above the floor [m]? Returns true when a hit counts now: the ball has left the
  /// racket and has risen.
  bool watch(bool touches, double above_racket, double above_floor) {
    if (lost) return false;
    lost = above_floor < 0;
    touched = touched || touches;
    if (lost || !touched || touches || above_racket < rules::rises) return false;
    touched = false;
    ++hits;
    best = std::max(best, hits);
    return true;
  }
};

// ---- Chance

/// A number from -1 to 1 that depends on the seed and on what it is for, and on nothing else: the
/// same game comes again. (The mixing is splitmix64; Steele, Lea and Flood 2014.)
inline double chance(std::uint64_t seed, int round, int hit, int which) {
  std::uint64_t mixed = seed;
  for (const int word : {round, hit, which}) {
    mixed += 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(word);
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    mixed ^= mixed >> 31;
  }
  return static_cast<double>(mixed >> 11) / 4503599627370496.0 - 1;  // 53 bits; 2^52
}

/// A push aside [m/s] of at most `strength`, in any direction.
inline Eigen::Vector3d push(double least, double strength, std::uint64_t seed, int round, int hit) {
  const double angle = std::numbers::pi * chance(seed, round, hit, 0);
  const double share = (1 + chance(seed, round, hit, 1)) / 2;
  const double speed = least + share * (strength - least);
  return {speed * std::cos(angle), 0, speed * std::sin(angle)};
}

}  // namespace bounce
