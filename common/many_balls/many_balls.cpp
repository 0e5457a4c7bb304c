#include "many_balls/many_balls.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bounce::many {

// [move]
void ManyBalls::move(const Laws& laws, const Eigen::VectorXd& mass, const Eigen::VectorXd& radius,
                     State<Matrix>& balls, Matrix& acceleration, Stepping stepping, long long count,
                     double dt, int threads) {
  if (mass.size() == 0 || count <= 0) return;
  dt_ = dt;
  const int most = static_cast<int>((mass.size() + 2 * group - 1) / (2 * group));
  Team team(std::min(threads, most));

  Pass step{};
  step.laws = laws;
  step.drift = dt;
  if (stepping == Stepping::semi_implicit_euler) {
    step.kicks = 1;
    step.kick = dt;
    load(mass, radius, balls);
    for (long long i = 0; i < count; ++i) pass(step, team);
    return store(balls);
  }
  // Velocity Verlet is half a kick, a drift, half a kick. The second half of one step and the first
  // half of the next need the same force, so one pass does both, and then drifts.
  step.kick = dt / 2;
  Pass last = step;
  last.drift = 0;
  if (acceleration.cols() == 0) {
    acceleration.resize(3, mass.size());
    last.acceleration = acceleration.data();
    load(mass, radius, balls);
    pass(last, team);  // no kicks: only the force at the start
  }
  last.acceleration = acceleration.data();
  balls.velocity += acceleration * step.kick;
  balls.position += balls.velocity * dt;
  step.kicks = 2;
  last.kicks = 1;
  load(mass, radius, balls);
  for (long long i = 1; i < count; ++i) pass(step, team);
  pass(last, team);
  store(balls);
}
// [move]

void ManyBalls::pass(const Pass& what, Team& team) {
  // Speeds change within a step, too; 1e-6 is for the rounding of the sum.
  const auto holds = [](double moved, double skin) { return moved <= skin / 2 * (1 - 1e-6); };
  const auto skin_for = [&](double steps) {
    return std::clamp(2 * steps * fastest_ * dt_, 0.02 * largest_radius_, 0.5 * largest_radius_);
  };
  if (!holds(moved_, skin_) || list_threads_ != team.size()) {
    skin_ = skin_for(120);
    list_threads_ = 0;  // no list, should it throw
    list_.build(now_, next_, number_, skin_, team);
    list_threads_ = team.size();
    moved_ = 0;
    thin_skin_ = -1;
    ++lists_built_;
  }
  if (!holds(moved_ - moved_before_, thin_skin_)) {
    thin_skin_ = std::min(skin_, skin_for(12));
    list_.shorten(now_, thin_skin_, team);
    moved_before_ = moved_;
  }
  speeds_.resize(static_cast<std::size_t>(list_.shares()));
  team.share_out(list_.shares(), [&](int share) {
    const auto [first, last] = list_.slots(share);
    Pass mine = what;
    mine.from = now_.data();
    mine.to = next_.data();
    mine.row = list_.rows(share);
    mine.neighbours = list_.neighbours(share);
    mine.number = number_.data();
    mine.touch = touch_;
    speeds_[static_cast<std::size_t>(share)] = pass_(mine, first, last);
  });
  now_.swap(next_);
  fastest_ = std::sqrt(*std::max_element(speeds_.begin(), speeds_.end()));
  moved_ += fastest_ * what.drift;
}

/// Takes over what the caller has. Where nothing was changed since the last call, or only as far as
/// the fastest ball comes in a step, the list still holds.
void ManyBalls::load(const Eigen::VectorXd& mass, const Eigen::VectorXd& radius,
                     const State<Matrix>& balls) {
  const auto count = static_cast<std::size_t>(mass.size());
  bool as_before = number_.size() == count && skin_ >= 0;
  if (number_.size() != count) {
    number_.resize(count);
    std::iota(number_.begin(), number_.end(), 0);
    now_.assign(count + 1, nobody);
    next_.assign(count + 1, nobody);
  }
  double furthest = 0, fastest = 0;
  for (std::size_t slot = 0; slot < count; ++slot) {
    const Eigen::Index i = number_[slot];
    BallRecord& ball = now_[slot];
    const Eigen::Vector3d p = balls.position.col(i), v = balls.velocity.col(i);
    const double distance_squared = (p - Eigen::Vector3d(ball.x, ball.y, ball.z)).squaredNorm();
    as_before = as_before && radius[i] == ball.radius && distance_squared < 1;  // and not a NaN
    if (as_before) furthest = std::max(furthest, distance_squared);
    fastest = std::max(fastest, v.squaredNorm());
    ball = {p.x(), p.y(), p.z(), v.x(), v.y(), v.z(), mass[i], radius[i]};
  }
  moved_ += std::sqrt(furthest);
  fastest_ = std::sqrt(fastest);
  if (as_before) return;
  skin_ = -1;
  largest_radius_ = radius.maxCoeff();
  touch_ = radius.minCoeff() == largest_radius_ ? 2 * largest_radius_ : 0;
}

void ManyBalls::store(State<Matrix>& balls) const {
  for (std::size_t slot = 0; slot < number_.size(); ++slot) {
    const BallRecord& ball = now_[slot];
    balls.position.col(number_[slot]) << ball.x, ball.y, ball.z;
    balls.velocity.col(number_[slot]) << ball.vx, ball.vy, ball.vz;
  }
}

std::size_t ManyBalls::bytes() const {
  return sizeof(BallRecord) * (now_.capacity() + next_.capacity()) +
         sizeof(int) * number_.capacity() + list_.bytes();
}

}  // namespace bounce::many
