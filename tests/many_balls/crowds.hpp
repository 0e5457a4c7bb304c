#pragma once
#include <random>

#include "05_ball_collision/ball_collision.hpp"
#include "05_ball_collision/scenes/scenes.hpp"
#include "many_balls/many_balls.hpp"

namespace bounce::test {

/// A scene of stage 5 and its balls at the start.
struct Crowd {
  BallCollision scene;
  State<Eigen::Matrix3Xd> balls;

  many::Laws laws() const {
    return {scene.gravity, scene.pair_contact(), scene.floor_contact(), scene.floor, scene.tray};
  }
};

inline Crowd crowd_of(const Arrangement& start, double stiffness, double damping,
                      std::array<double, 2> tray) {
  Crowd crowd;
  crowd.balls = start.balls;
  crowd.scene.mass = start.mass;
  crowd.scene.radius = start.radius;
  crowd.scene.stiffness = crowd.scene.floor_stiffness = stiffness;
  crowd.scene.damping = crowd.scene.floor_damping = damping;
  crowd.scene.tray = tray;
  return crowd;
}

/// The balls of `scene=drop`, closer together and just above the floor, thrown down at 2 m/s with
/// up to 1 m/s more or less in every direction: within 0.1 s each meets several others, floor and
/// walls.
inline Crowd collapse(int count) {
  const std::array<double, 2> tray{tray_for(count), tray_for(count)};
  Arrangement start = drop(count, 0.006, tray, 1);
  std::mt19937_64 chance(2);
  const auto random = [&] { return static_cast<double>(chance() >> 11) * 0x1p-52 - 1; };
  for (Eigen::Index i = 0; i < count; ++i) {
    start.balls.position(1, i) -= 0.29;
    for (int axis = 0; axis < 3; ++axis) start.balls.velocity(axis, i) = random();
    start.balls.velocity(1, i) -= 2;
  }
  return crowd_of(start, 1e5, 100, tray);
}

inline int contacts(const Crowd& crowd) {
  int touching = 0;
  crowd.scene.for_each_pair(crowd.balls.position, [&](Eigen::Index i, Eigen::Index j) {
    touching +=
        meet(crowd.scene.ball(crowd.balls, i), crowd.scene.ball(crowd.balls, j)).overlap > 0;
  });
  return touching;
}

}  // namespace bounce::test
