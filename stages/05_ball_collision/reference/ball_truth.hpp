#pragma once
#include <algorithm>
#include <optional>

#include "05_ball_collision/reference/ball_contacts.hpp"
#include "physics/reference.hpp"

namespace bounce {

using BallReference = Reference<BallContacts, Eigen::Matrix3Xd>;

/// What the other methods are compared with: the reference, as tight as doubles allow, for a few
/// balls. With many the comparison would take too long, and soon be none: each collision multiplies
/// an error, so that two runs that differ by rounding part after some twenty of them.
class BallTruth {
 public:
  using Balls = State<Eigen::Matrix3Xd>;
  static constexpr Eigen::Index most_balls = 9;

  BallTruth() = default;  // none
  BallTruth(const BallCollision& scene, double t, const Balls& balls) {
    if (balls.position.cols() > most_balls) return;
    walk_.emplace(BallContacts(scene, balls), t, balls, tolerance);
  }

  /// The balls at `t`, which may lie a little before the last one asked for. Nothing where the
  /// reference does not get there, or takes too long.
  std::optional<Balls> at(double t) {
    try {
      if (!walk_ || !walk_->reach(t, most_pieces)) return std::nullopt;
      Balls balls = walk_->at(std::max(t, walk_->piece_start()));
      if (balls.position.allFinite() && balls.velocity.allFinite()) return balls;
    } catch (const TimeStandsStill&) {
      walk_.reset();
    }
    return std::nullopt;
  }

 private:
  static constexpr double tolerance = 1e-13;
  static constexpr long long most_pieces = 20000;  // a comparison is worth a second, not an hour

  std::optional<BallReference> walk_;
};

}  // namespace bounce
