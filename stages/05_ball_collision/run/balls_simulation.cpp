#include "05_ball_collision/run/balls_simulation.hpp"

#include "physics/integrators.hpp"
#include "physics/stability.hpp"

namespace bounce {

// ---- What it is

many::Laws BallsSimulation::laws() const {
  return {scene_.gravity, scene_.pair_contact(), scene_.floor_contact(), scene_.floor, scene_.tray};
}

std::unique_ptr<Simulation> BallsSimulation::clone() const {
  return std::make_unique<BallsSimulation>(*this);
}

std::vector<Method> BallsSimulation::methods() const {
  return {Method::explicit_euler, Method::semi_implicit_euler, Method::velocity_verlet, Method::rk4,
          Method::reference};
}

void BallsSimulation::check_method() const {
  if (method() == Method::reference && balls() > most_balls_of_reference) {
    throw BadInput("--method reference is not allowed with " + std::to_string(balls()) +
                   " balls: " + why_not_so_many);
  }
}

std::vector<std::string> BallsSimulation::columns() const {
  return {"ball", "x", "y", "z", "vx", "vy", "vz"};
}

/// The contact that asks for the smallest time step: between the two lightest balls, or of the
/// lightest one with the floor. (A ball that touches several at a time asks for less still.)
std::optional<ContactNumbers> BallsSimulation::contact() const {
  double lightest = 1e300, second = 1e300;
  for (const double mass : scene_.mass) {
    second = std::min(second, std::max(mass, lightest));
    lightest = std::min(lightest, mass);
  }
  std::optional<ContactNumbers> hardest;
  const auto consider = [&hardest](double k, double c, double mass) {
    const ContactNumbers contact{natural_frequency(k, mass), damping_ratio(k, c, mass)};
    const auto limit = [](const ContactNumbers& of) {
      return semi_implicit_euler_limit(of.zeta) / of.omega0;
    };
    if (!hardest || limit(contact) < limit(*hardest)) hardest = contact;
  };
  if (scene_.floor || scene_.tray[0] > 0 || scene_.tray[1] > 0) {
    consider(scene_.floor_stiffness, scene_.floor_damping, lightest);
  }
  if (scene_.mass.size() > 1) {
    consider(scene_.stiffness, scene_.damping, 1 / (1 / lightest + 1 / second));
  }
  return hardest;
}

/// A row for each ball.
std::vector<double> BallsSimulation::rows_of(const Balls& at) const {
  std::vector<double> rows;
  rows.reserve(7 * balls());
  for (Eigen::Index i = 0; i < scene_.mass.size(); ++i) {
    rows.push_back(static_cast<double>(i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(at.position(axis, i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(at.velocity(axis, i));
  }
  return rows;
}

void BallsSimulation::place(const std::vector<double>& values) {
  for (std::size_t i = 0; i < balls(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<Eigen::Index>(i);
      const std::size_t at = 7 * i + 1 + static_cast<std::size_t>(axis);
      state_.position(axis, column) = values.at(at);
      state_.velocity(axis, column) = values.at(at + 3);
    }
  }
  parameters_changed();
}

// ---- Moving

void BallsSimulation::parameters_changed() {
  verlet_.acceleration.reset();
  reference_.reset();
  if (method() == Method::reference && has_balls() && balls() <= most_balls_of_reference) {
    reference_.emplace(fresh_reference());
  }
  compare_from_here();
}

BallReference BallsSimulation::fresh_reference() const {
  return {{scene_, state_}, time(), state_, tolerance()};
}

void BallsSimulation::take_steps_of_many(long long count, double dt) {
  const bool is_verlet = method() == Method::velocity_verlet;
  if (!verlet_.acceleration) verlet_.acceleration.emplace(3, 0);
  many_.move(laws(), scene_.mass, scene_.radius, state_, *verlet_.acceleration,
             is_verlet ? many::Stepping::velocity_verlet : many::Stepping::semi_implicit_euler,
             count, dt, threads_);
  if (!is_verlet) verlet_.acceleration.reset();
}

void BallsSimulation::take_steps(long long count, double t, double dt) {
  Balls before;
  const auto loop = [&](auto&& step) {
    for (long long i = 0; i < count; ++i) {
      if (keep_book_) before = state_;
      step(scene_, t + static_cast<double>(i) * dt, state_, dt);
      if (!keep_book_) continue;
      // The dampers' work over the step, by the midpoint rule.
      before.position = (before.position + state_.position) / 2;
      before.velocity = (before.velocity + state_.velocity) / 2;
      lost_ += scene_.damper_power(before) * dt;
    }
  };
  using S = const BallCollision&;
  if (scene_.mass.size() >= many_from_ &&
      (method() == Method::semi_implicit_euler || method() == Method::velocity_verlet)) {
    if (!keep_book_) return take_steps_of_many(count, dt);
    return loop([this](S, double, Balls&, double h) { take_steps_of_many(1, h); });
  }
  switch (method()) {
    case Method::explicit_euler:
      return loop([](S s, double now, Balls& x, double h) { explicit_euler(s, now, x, h); });
    case Method::semi_implicit_euler:
      return loop([](S s, double now, Balls& x, double h) { semi_implicit_euler(s, now, x, h); });
    case Method::velocity_verlet:
      return loop(verlet_);
    case Method::rk4:
      return loop([](S s, double now, Balls& x, double h) { rk4(s, now, x, h); });
    default:
      return;  // the others need a closed form, and are not offered
  }
}

double BallsSimulation::go_by_events_towards(double t, long long most_events) {
  if (!reference_) throw NoClosedForm(time(), why_not_so_many);
  // So many that one can be heard in between.
  const auto pairs = static_cast<long long>(balls() * balls());
  const long long most = std::max(1LL, most_events / pairs);
  const double there = reference_->reach(t, most) ? t : reference_->piece_start();
  state_ = reference_->at(there);
  return there;
}

// ---- What the others are compared with, and the books

std::vector<double> BallsSimulation::exact_values(double t) const {
  const std::optional<Balls> exact = truth_.at(t);
  return exact ? rows_of(*exact) : std::vector<double>{};
}

std::optional<StateError> BallsSimulation::error() const {
  const std::optional<Balls> exact = truth_.at(time());
  if (!exact) return std::nullopt;
  return StateError{(state_.position - exact->position).colwise().norm().maxCoeff(),
                    (state_.velocity - exact->velocity).colwise().norm().maxCoeff()};
}

std::optional<double> BallsSimulation::exact_energy() const {
  const std::optional<Balls> exact = truth_.at(time());
  if (!exact) return std::nullopt;
  return scene_.energy(*exact).total();
}

Energy BallsSimulation::energy() const { return scene_.energy(state_); }

double BallsSimulation::energy_lost() const {
  // The reference keeps no book of steps: without a formula for it, what is missing was lost.
  return reference_ ? energy_before_ - energy().total() : lost_;
}

double BallsSimulation::next_event() const { return reference_ ? reference_->next_event() : never; }

long long BallsSimulation::counted_force_evaluations() const {
  return reference_ ? reference_->force_evaluations() : 0;
}

void BallsSimulation::compare_from_here() {
  if (has_balls()) truth_ = BallTruth(scene_, time(), state_);
  energy_before_ = energy().total();
  lost_ = 0;
}

bool BallsSimulation::is_finite() const {
  return state_.position.allFinite() && state_.velocity.allFinite();
}

}  // namespace bounce
