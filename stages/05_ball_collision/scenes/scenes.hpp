#pragma once
#include <cmath>
#include <cstdint>
#include <random>

#include "05_ball_collision/ball_collision.hpp"

namespace bounce {

/// The built-in scenes, in the order of `scene=pair|break|cradle|tower|drop`.
enum class BallScene { pair, break_up, cradle, tower, drop };

/// Balls at the start of a run.
struct Arrangement {
  Eigen::VectorXd mass;             // kg
  Eigen::VectorXd radius;           // m
  State<Eigen::Matrix3Xd> balls{};  // m, m/s

  explicit Arrangement(Eigen::Index count, double ball_radius = 0.1)
      : mass(Eigen::VectorXd::Ones(count)), radius(Eigen::VectorXd::Constant(count, ball_radius)) {
    balls.position.setZero(3, count);
    balls.velocity.setZero(3, count);
  }
};

/// Balls that "touch" are this far apart [m], so that no rounding makes an overlap of it.
inline constexpr double hair = 1e-12;

/// What a scene is made from.
struct SceneChoice {
  BallScene scene = BallScene::pair;
  double count = 2;  // balls, for break, cradle and drop; pair and tower have two
  double gap = 0;    // m, see each scene
};

/// Two balls on a table without friction: the first comes along x, the second is at rest. The first
/// one's path passes the second's centre at a distance `gap`: 0 is head-on, 2 r and more a miss.
inline Arrangement pair_of_balls(double gap) {
  Arrangement start(2);
  start.balls.position << -0.6, 0,  //
      0.1, 0.1,                     //
      gap, 0;
  start.balls.velocity(0, 0) = 1;
  return start;
}

/// A triangle of balls on a table, `gap` apart, and one that hits its corner.
inline Arrangement break_up(int count, double gap) {
  Arrangement start(count);
  start.balls.position.row(1).setConstant(0.1);
  start.balls.position(0, 0) = -1;
  start.balls.velocity(0, 0) = 3;
  const double spacing = 0.2 + hair + gap;
  int ball = 1;
  for (int row = 0; ball < count; ++row) {
    for (int place = 0; place <= row && ball < count; ++place, ++ball) {
      start.balls.position(0, ball) = spacing * row * std::sqrt(0.75);
      start.balls.position(2, ball) = spacing * (place - row / 2.0);
    }
  }
  return start;
}

/// A row of balls at rest, `gap` apart, and one that comes along the row.
inline Arrangement cradle(int count, double gap) {
  Arrangement start(count);
  start.balls.position.row(1).setConstant(0.1);
  for (int ball = 0; ball < count; ++ball) {
    start.balls.position(0, ball) = (0.2 + hair + gap) * (ball - (count - 1) / 2.0);
  }
  start.balls.position(0, 0) -= 0.3;
  start.balls.velocity(0, 0) = 0.3;
  return start;
}

/// A small ball above a big one of ten times its mass, `gap` between them, falls on the floor from
/// 0.8 m. The radii fit the masses: the same material.
inline Arrangement tower(double gap) {
  Arrangement start(2);
  start.mass << 10, 1;
  // The cube root of 10, written out: not every compiler and C library rounds it alike.
  start.radius << 0.2, 0.2 / 2.1544346900318838;
  start.balls.position(1, 0) = 0.8 + start.radius[0];
  start.balls.position(1, 1) = start.balls.position(1, 0) + start.radius.sum() + gap;
  return start;
}

/// The width of a tray that `count` balls with radius 0.05 m fill to half of its width, when they
/// lie there and fill 60 % of the space.
inline double tray_for(double count) {
  const double volume = count * 4.0 / 3.0 * std::acos(-1.0) * std::pow(0.05, 3) / 0.6;
  return std::max(0.4, std::cbrt(2 * volume));
}

/// Balls on a lattice, `gap` apart and each moved a little by chance, above a tray of that size.
inline Arrangement drop(int count, double gap, std::array<double, 2> tray, std::uint64_t seed) {
  constexpr double radius = 0.05;
  Arrangement start(count, radius);
  const double spacing = 2 * radius + gap;
  const auto fitting = [&](double width) {
    const double square = std::sqrt(count) * spacing;  // where there are no walls
    return std::max(1.0, std::floor((width > 0 ? width : square) / spacing));
  };
  const double nx = fitting(tray[0]), nz = fitting(tray[1]);
  std::mt19937_64 chance(seed);
  const auto jitter = [&] {  // the generator's own bits: the same on every machine
    return (static_cast<double>(chance() >> 11) * 0x1p-52 - 1) * 0.48 * gap;
  };
  const double margin_x = std::max(0.0, tray[0] - nx * spacing) / 2;
  const double margin_z = std::max(0.0, tray[1] - nz * spacing) / 2;
  for (int ball = 0; ball < count; ++ball) {
    const double ix = std::fmod(ball, nx), layer = std::floor(ball / (nx * nz));
    const double iz = std::fmod(std::floor(ball / nx), nz);
    start.balls.position(0, ball) = margin_x + (ix + 0.5) * spacing + jitter();
    start.balls.position(1, ball) = 0.3 + (layer + 0.5) * spacing + jitter();
    start.balls.position(2, ball) = margin_z + (iz + 0.5) * spacing + jitter();
  }
  return start;
}

inline Arrangement arrange(const SceneChoice& choice, std::array<double, 2> tray,
                           std::uint64_t seed) {
  const int count = static_cast<int>(choice.count);
  switch (choice.scene) {
    case BallScene::pair:
      return pair_of_balls(choice.gap);
    case BallScene::break_up:
      return break_up(count, choice.gap);
    case BallScene::cradle:
      return cradle(count, choice.gap);
    case BallScene::tower:
      return tower(choice.gap);
    case BallScene::drop:
      break;
  }
  return drop(count, choice.gap, tray, seed);
}

}  // namespace bounce
