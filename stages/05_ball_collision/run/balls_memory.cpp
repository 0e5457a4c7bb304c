// What BallsSimulation remembers, for `--save` and `--load`.

#include "05_ball_collision/run/balls_simulation.hpp"
#include "run/saved_numbers.hpp"

namespace bounce {

// ---- As plain numbers: how many balls, whether they came from a file, and the seed; masses,
// radii, positions, velocities; the start of balls from a file; what velocity Verlet or the
// reference carries.

std::vector<double> BallsSimulation::numbers() const {
  std::vector<double> all{static_cast<double>(balls()), own_balls_ ? 1.0 : 0.0,
                          static_cast<double>(seed_)};
  append(all, scene_.mass);
  append(all, scene_.radius);
  append(all, state_);
  if (own_balls_) append(all, own_balls_->balls);
  if (method() == Method::velocity_verlet && verlet_.acceleration) {
    append(all, *verlet_.acceleration);
  }
  if (reference_) {
    all.push_back(reference_->next_step());
    all.push_back(reference_->piece_start());
    append(all, reference_->state_at_piece_start());
    for (const double phase : reference_->contacts().phases()) all.push_back(phase);
  }
  return all;
}

bool BallsSimulation::recall_numbers(const std::vector<double>& all) {
  if (all.size() < 3 || !(all[0] >= 1 && all[0] <= 1e9) || !(all[2] >= 0 && all[2] <= 1e15)) {
    return false;
  }
  const auto count = static_cast<std::size_t>(all[0]);
  const bool own = all[1] == 1;
  const std::size_t needed = 3 + count * (own ? 14 : 8);
  const bool carries = all.size() == needed + 3 * count && method() == Method::velocity_verlet;
  const bool is_reference = method() == Method::reference;
  if (is_reference ? all.size() < needed : all.size() != needed && !carries) return false;

  std::size_t next = 3;
  const auto take = [&](auto&& matrix) {
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(next), matrix.size(), matrix.data());
    next += static_cast<std::size_t>(matrix.size());
  };
  Arrangement now(static_cast<Eigen::Index>(count));
  take(now.mass);
  take(now.radius);
  take(now.balls.position);
  take(now.balls.velocity);
  if (!(now.mass.array() > 0).all() || !(now.radius.array() > 0).all()) return false;
  seed_ = static_cast<std::uint64_t>(all[2]);
  scene_.mass = now.mass;
  scene_.radius = now.radius;
  state_ = now.balls;
  own_balls_ = nullptr;
  if (own) {
    take(now.balls.position);
    take(now.balls.velocity);
    own_balls_ = std::make_shared<const Arrangement>(now);
  }
  verlet_.acceleration.reset();
  if (carries) take(verlet_.acceleration.emplace(3, now.mass.size()));
  return !is_reference || recall_reference(std::span(all).subspan(next));
}

/// The next step, the piece's start, the balls there, and who touches.
bool BallsSimulation::recall_reference(std::span<const double> numbers) {
  const auto in_matrix = static_cast<std::size_t>(state_.position.size());
  if (numbers.size() < 2 + 2 * in_matrix || balls() > most_balls_of_reference) return false;
  const double step = numbers[0], start = numbers[1];
  if (!(step > 0 && start >= 0 && start <= time())) return false;
  Balls balls = state_;
  std::copy_n(numbers.begin() + 2, in_matrix, balls.position.data());
  numbers = numbers.subspan(2 + in_matrix);
  std::copy_n(numbers.begin(), in_matrix, balls.velocity.data());
  BallContacts contacts(scene_, balls);
  if (!contacts.recall_phases(numbers.subspan(in_matrix))) return false;
  reference_.emplace(fresh_reference()).resume(contacts, start, balls, step);
  return true;
}

}  // namespace bounce
