#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "05_ball_collision/reference/touching.hpp"
#include "physics/neighbour_grid.hpp"

namespace bounce {

/// Calls visit(two) for all balls that are no further than `range` [m] from a surface.
template <class Visit>
void for_each_surface(const BallCollision& scene, const Eigen::Matrix3Xd& position, double range,
                      const Visit& visit) {
  for (int i = 0; i < scene.mass.size(); ++i) {
    scene.for_each_surface(position, i, [&](Eigen::Index axis, double sign, double overlap) {
      if (overlap >= -range) visit({i, -1, static_cast<int>(axis), sign > 0 ? 1 : -1});
    });
  }
}

/// Who is near whom. The list is made wider than is asked for, and kept until somebody may have
/// come near who is not in it. It is memory, not knowledge: what is visited does not depend on its
/// age.
class NearPairs {
 public:
  /// Calls visit(two), in order, for all that are no further apart than `range`, and some more.
  template <class Visit>
  void for_each(const BallCollision& scene, const State<Eigen::Matrix3Xd>& balls, double range,
                const Visit& visit) {
    const double wider = 1.5 * range + scene.radius.minCoeff() / 4;
    if (range_ > 2 * wider || !is_wide_enough(balls.position, range)) {
      list(scene, balls.position, wider);
    }
    for (const ContactPair& two : pairs_) visit(two);
  }

 private:
  bool is_wide_enough(const Eigen::Matrix3Xd& position, double range) const {
    if (position.cols() != listed_at_.cols()) return false;
    const double may_move = (range_ - range) / 2;
    return ((position - listed_at_).colwise().norm().array() <= may_move).all();
  }

  void list(const BallCollision& scene, const Eigen::Matrix3Xd& position, double range) {
    range_ = range;
    listed_at_ = position;
    pairs_.clear();
    for_each_surface(scene, position, range,
                     [&](const ContactPair& two) { pairs_.push_back(two); });
    const Eigen::VectorXd reach = scene.radius.array() + range / 2;
    for (const auto& [i, j] : grid_.pairs(position, reach)) pairs_.push_back({i, j});
    std::sort(pairs_.begin(), pairs_.end());
  }

  std::vector<ContactPair> pairs_;
  double range_ = 0;            // m: all are listed that were no further apart
  Eigen::Matrix3Xd listed_at_;  // m: when all were there
  NeighbourGrid grid_;
};

}  // namespace bounce
