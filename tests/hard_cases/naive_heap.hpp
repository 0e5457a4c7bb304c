#pragma once
#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "05_ball_collision/ball_collision.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::naive {

/// 27 balls that fall into a tray. Nothing damps them: they are chaotic.
struct Heap {
  static constexpr int count = 27;
  static constexpr double dt = 1e-3;  // omega0 dt is 0.14
  static constexpr int steps = 3000;  // 3 s
  BallCollision scene;
  State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd::Zero(3, count)};

  Heap() {
    scene.tray = {1, 1};
    scene.mass = Eigen::VectorXd::Ones(count);
    scene.radius = Eigen::VectorXd::Constant(count, 0.1);
    for (int i = 0; i < count; ++i) {  // layers of nine, each ball a little off its place
      const double x = std::fmod(i * 0.755, 1) / 20, z = std::fmod(i * 0.57, 1) / 20;
      balls.position.col(i) << 0.2 + 0.3 * (i % 3) + x, 0.2 + 0.3 * (i / 9),
          0.2 + 0.3 * (i / 3 % 3) + z;
    }
  }

  /// After 3 s with dampers: they lie on each other.
  static Heap at_rest() {
    Heap heap;
    heap.scene.damping = heap.scene.floor_damping = 50;
    for (int i = 0; i < steps; ++i) semi_implicit_euler(heap.scene, 0, heap.balls, dt);
    return heap;
  }

  /// On how many balls the push of all others changes when it is summed like that, and not one by
  /// one in the order of their numbers.
  template <class Sum>
  int changed_sums(const Sum& sum) const {
    int changed = 0;
    for (int i = 0; i < count; ++i) {
      std::vector<Eigen::Vector3d> pushes;
      Eigen::Vector3d one_by_one = Eigen::Vector3d::Zero();
      for (int j = 0; j < count; ++j) {
        if (j == i) continue;
        pushes.push_back(
            pair_force(scene.ball(balls, i), scene.ball(balls, j), scene.pair_contact()));
        one_by_one += pushes.back();
      }
      changed += sum(pushes) != one_by_one ? 1 : 0;
    }
    return changed;
  }

  /// Names the balls the other way round.
  void reverse() {
    balls.position = balls.position.rowwise().reverse().eval();
    balls.velocity = balls.velocity.rowwise().reverse().eval();
  }

  /// How far the ball is away that has moved most from where `other` has it [m].
  double distance_to(const Heap& other) const {
    return std::sqrt((balls.position - other.balls.position).colwise().squaredNorm().maxCoeff());
  }
};

}  // namespace bounce::naive
