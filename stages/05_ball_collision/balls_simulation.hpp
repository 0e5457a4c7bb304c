#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ball_collision.hpp"
#include "ball_truth.hpp"
#include "many_balls/lammps_import.hpp"
#include "many_balls/many_balls.hpp"
#include "physics/event_driven.hpp"
#include "physics/integrators.hpp"
#include "physics/stability.hpp"
#include "run/options.hpp"
#include "run/simulation.hpp"
#include "scenes.hpp"

namespace bounce {

/// Runs the balls of a built-in scene, or those of a file.
class BallsSimulation final : public Simulation {
 public:
  using Balls = State<Eigen::Matrix3Xd>;

  BallsSimulation() {
    choose_scene(BallScene::pair);
    reset_state();
  }

  const BallCollision& scene() const { return scene_; }
  const Balls& state() const { return state_; }
  BallScene chosen_scene() const { return choice_.scene; }
  bool has_own_balls() const { return own_balls_ != nullptr; }
  const std::shared_ptr<const Arrangement>& own_balls() const { return own_balls_; }

  /// Balls of the user's own, in place of a scene. `origin` is the file they came from.
  void use_balls(Arrangement balls, const std::string& origin);
  /// Goes on from balls that another program has moved, as if this run had done it. Masses and
  /// radii stay those of the scene where the frame has none. Throws BadInput when that cannot be.
  void continue_from(const many::LammpsFrame& frame, const std::string& origin);
  many::Laws laws() const {
    return {scene_.gravity, scene_.pair_contact(), scene_.floor_contact(), scene_.floor,
            scene_.tray};
  }
  /// The option `--threads`: for many balls (below). The result is the same, to the bit.
  void use_threads(int threads) { threads_ = threads; }
  /// From so many balls on, the steps of semi-implicit Euler and velocity Verlet are taken by
  /// many::ManyBalls, which is faster (see the lesson) and gives the same bits.
  void use_many_from(Eigen::Index count) { many_from_ = count; }

  std::unique_ptr<Simulation> clone() const override {
    return std::make_unique<BallsSimulation>(*this);
  }
  std::vector<Parameter> parameters() override;
  std::vector<Method> methods() const override {
    return {Method::explicit_euler, Method::semi_implicit_euler, Method::velocity_verlet,
            Method::rk4, Method::reference};
  }
  void check_method() const override {
    if (method() == Method::reference && balls() > most_balls_of_reference) {
      throw BadInput("--method reference is not allowed with " + std::to_string(balls()) +
                     " balls: " + why_not_so_many);
    }
  }
  std::vector<std::string> columns() const override {
    return {"ball", "x", "y", "z", "vx", "vy", "vz"};
  }
  std::size_t balls() const override { return static_cast<std::size_t>(scene_.mass.size()); }
  std::vector<double> values() const override { return rows_of(state_); }
  std::string stage_options() const override;
  std::optional<ContactNumbers> contact() const override;

  void use_seed(std::uint64_t seed) override { seed_ = seed; }
  void place(const std::vector<double>& values) override;
  void parameters_changed() override {
    verlet_.acceleration.reset();
    reference_.reset();
    if (method() == Method::reference && has_balls() && balls() <= most_balls_of_reference) {
      reference_.emplace(fresh_reference());
    }
    compare_from_here();
  }

  Energy energy() const override { return scene_.energy(state_); }
  void keep_energy_book(bool keep) override { keep_book_ = keep; }
  double energy_before() const override { return energy_before_; }

  // The reference keeps no book of steps: without a formula for it, what is missing was lost.
  double energy_lost() const override {
    return reference_ ? energy_before_ - energy().total() : lost_;
  }

  // There is no formula for many balls, but for a few there is the reference.
  std::vector<double> exact_values(double t) const override {
    const std::optional<Balls> exact = truth_.at(t);
    return exact ? rows_of(*exact) : std::vector<double>{};
  }
  std::optional<StateError> error() const override {  // of the ball that is off most
    const std::optional<Balls> exact = truth_.at(time());
    if (!exact) return std::nullopt;
    return StateError{(state_.position - exact->position).colwise().norm().maxCoeff(),
                      (state_.velocity - exact->velocity).colwise().norm().maxCoeff()};
  }
  std::optional<double> exact_energy() const override {
    const std::optional<Balls> exact = truth_.at(time());
    if (!exact) return std::nullopt;
    return scene_.energy(*exact).total();
  }
  double next_event() const override { return reference_ ? reference_->next_event() : never; }
  long long counted_force_evaluations() const override {
    return reference_ ? reference_->force_evaluations() : 0;
  }

 protected:
  void reset_state() override;
  void compare_from_here() override {
    if (has_balls()) truth_ = BallTruth(scene_, time(), state_);
    energy_before_ = energy().total();
    lost_ = 0;
  }
  void take_steps(long long count, double t, double dt) override;
  double go_by_events_towards(double t, long long most_events) override;
  bool is_finite() const override {
    return state_.position.allFinite() && state_.velocity.allFinite();
  }
  std::vector<double> numbers() const override;
  bool recall_numbers(const std::vector<double>& all) override;

 private:
  void choose_scene(BallScene scene);
  // A scene that was just chosen has no balls before the restart.
  bool has_balls() const { return scene_.mass.size() == state_.position.cols(); }
  std::vector<double> rows_of(const Balls& at) const;
  bool recall_reference(std::span<const double> numbers);
  void take_steps_of_many(long long count, double dt);

  // The reference looks at all pairs at every event: a method for few balls.
  static constexpr std::size_t most_balls_of_reference = 1000;
  static constexpr const char* why_not_so_many =
      "the method reference looks at all pairs of balls, and takes at most 1000 balls";
  BallReference fresh_reference() const { return {{scene_, state_}, time(), state_, tolerance()}; }

  BallCollision scene_;
  SceneChoice choice_;
  std::array<double, 2> tray_of_scene_{};  // while `tray` is still this, it follows the count
  std::shared_ptr<const Arrangement> own_balls_;
  std::string origin_;  // of the own balls: the option that brought them
  std::uint64_t seed_ = 1;
  int threads_ = 1;
  Eigen::Index many_from_ = 32;
  many::ManyBalls many_;

  Balls state_;
  VelocityVerlet<Eigen::Matrix3Xd> verlet_;
  std::optional<BallReference> reference_;  // while it is the method
  mutable BallTruth truth_;                 // what all others are compared with
  bool keep_book_ = false;
  double energy_before_ = 0;
  double lost_ = 0;
};

// ---- Setting it up

/// A scene brings the parameters that suit it; whoever wants others sets them after it.
inline void BallsSimulation::choose_scene(BallScene scene) {
  own_balls_ = nullptr;
  scene_ = BallCollision{};
  choice_ = {scene, 2, 0};
  switch (scene) {
    case BallScene::pair:
      scene_.gravity = 0;  // a table without friction, on which gravity has nothing to say
      break;
    case BallScene::break_up:
      scene_.gravity = 0;
      choice_.count = 16;
      break;
    case BallScene::cradle:
      scene_.gravity = 0;
      choice_.count = 5;
      break;
    case BallScene::tower:  // hard balls, so that the one is done before the other begins
      scene_.stiffness = scene_.floor_stiffness = 1e5;
      break;
    case BallScene::drop:
      choice_.count = 300;
      choice_.gap = 0.0143;  // the lattice fills 35 % of the space
      scene_.stiffness = scene_.floor_stiffness = 2e4;
      scene_.damping = scene_.floor_damping = 20;
      scene_.tray = {tray_for(choice_.count), tray_for(choice_.count)};
      break;
  }
  tray_of_scene_ = scene_.tray;
}

inline void BallsSimulation::use_balls(Arrangement balls, const std::string& origin) {
  choose_scene(BallScene::pair);
  scene_.gravity = BallCollision{}.gravity;
  own_balls_ = std::make_shared<const Arrangement>(std::move(balls));
  origin_ = "--balls " + origin;
}

inline void BallsSimulation::continue_from(const many::LammpsFrame& frame,
                                           const std::string& origin) {
  const Eigen::Index count = frame.balls.position.cols();
  const bool complete = frame.mass.size() == count && frame.radius.size() == count;
  if (!complete && count != scene_.mass.size()) {
    throw BadInput(origin + " is not allowed: it has " + std::to_string(count) +
                   " balls without mass and radius, and the scene has " +
                   std::to_string(scene_.mass.size()) +
                   ": set count, or dump the columns mass and radius as well");
  }
  Arrangement balls(count);
  balls.mass = frame.mass.size() == count ? frame.mass : scene_.mass;
  balls.radius = frame.radius.size() == count ? frame.radius : scene_.radius;
  balls.balls = frame.balls;
  scene_.mass = balls.mass;
  scene_.radius = balls.radius;
  state_ = balls.balls;
  own_balls_ = std::make_shared<const Arrangement>(std::move(balls));
  origin_ = origin;
  parameters_changed();
  // The acceleration at the end of the last step is part of velocity Verlet's state: with damping
  // it is not what the new velocity would give.
  if (method() == Method::velocity_verlet && frame.force.cols() == count) {
    verlet_.acceleration = frame.force;
    for (Eigen::Index i = 0; i < count; ++i) verlet_.acceleration->col(i) /= scene_.mass[i];
  }
  Memory clock = memory();
  clock.time = static_cast<double>(frame.step) * dt();
  clock.grid_start = clock.into_step = 0;
  clock.grid_steps = clock.steps = frame.step;
  recall(clock);
}

inline void BallsSimulation::reset_state() {
  if (choice_.scene == BallScene::drop && scene_.tray == tray_of_scene_) {
    scene_.tray = {tray_for(choice_.count), tray_for(choice_.count)};
    tray_of_scene_ = scene_.tray;
  }
  const Arrangement start = own_balls_ ? *own_balls_ : arrange(choice_, scene_.tray, seed_);
  scene_.mass = start.mass;
  scene_.radius = start.radius;
  state_ = start.balls;
  parameters_changed();
}

inline std::vector<Parameter> BallsSimulation::parameters() {
  Choice scenes{{"pair", "break", "cradle", "tower", "drop"},
                [this] { return static_cast<std::size_t>(choice_.scene); },
                [this](std::size_t index) { choose_scene(static_cast<BallScene>(index)); }};
  Parameter scene{"scene", "", "the balls at the start; it brings its own defaults of all others",
                  std::move(scenes)};
  scene.is_start = scene.chooses_defaults = true;
  // What is worth playing with depends on the scene: [lowest, highest] of its sliders.
  constexpr std::array<Range, 5> counts{{{2, 3}, {2, 56}, {2, 9}, {2, 3}, {2, 1000}}};
  constexpr std::array<Range, 5> gaps{{{0, 0.25}, {0, 0.05}, {0, 0.01}, {0, 0.2}, {0, 0.1}}};
  const auto chosen = static_cast<std::size_t>(choice_.scene);
  Parameter count{"count",        "",  "balls of break, cradle and drop", &choice_.count, {1, 1e7},
                  counts[chosen], true};
  count.is_whole = true;
  Parameter gap{
      "gap",        "m",      "between the balls at the start; in pair: how far off centre",
      &choice_.gap, {0, 1e6}, gaps[chosen],
      true};
  Parameter floor_stiffness{"floor_stiffness",       "N/m",         "the same for floor and walls",
                            &scene_.floor_stiffness, {1e-30, 1e30}, {500, 1e5}};
  Parameter floor_damping{"floor_damping",       "N s/m",   "the same for floor and walls",
                          &scene_.floor_damping, {0, 1e30}, {0, 300}};
  Parameter tray{
      "tray",    "m",   "walls at x = 0 and LX, z = 0 and LZ; 0 for none", Components(scene_.tray),
      {0, 1e15}, {0, 5}};
  return {scene,
          count,
          gap,
          describe::gravity(scene_.gravity),
          describe::stiffness(scene_.stiffness),
          describe::damping(scene_.damping),
          describe::contact(scene_.contact),
          describe::floor(scene_.floor),
          floor_stiffness,
          floor_damping,
          tray};
}

inline std::string BallsSimulation::stage_options() const {
  std::string words;
  if (own_balls_) words += " " + origin_;
  if (threads_ != 1) words += " --threads " + std::to_string(threads_);
  if (seed_ != 1) words += " --seed " + std::to_string(seed_);
  return words;
}

// ---- What it is

/// The contact that asks for the smallest time step: between the two lightest balls, or of the
/// lightest one with the floor. (A ball that touches several at a time asks for less still.)
inline std::optional<ContactNumbers> BallsSimulation::contact() const {
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
inline std::vector<double> BallsSimulation::rows_of(const Balls& at) const {
  std::vector<double> rows;
  rows.reserve(7 * balls());
  for (Eigen::Index i = 0; i < scene_.mass.size(); ++i) {
    rows.push_back(static_cast<double>(i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(at.position(axis, i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(at.velocity(axis, i));
  }
  return rows;
}

inline void BallsSimulation::place(const std::vector<double>& values) {
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

inline void BallsSimulation::take_steps_of_many(long long count, double dt) {
  const bool is_verlet = method() == Method::velocity_verlet;
  if (!verlet_.acceleration) verlet_.acceleration.emplace(3, 0);
  many_.move(laws(), scene_.mass, scene_.radius, state_, *verlet_.acceleration,
             is_verlet ? many::Stepping::velocity_verlet : many::Stepping::semi_implicit_euler,
             count, dt, threads_);
  if (!is_verlet) verlet_.acceleration.reset();
}

inline void BallsSimulation::take_steps(long long count, double t, double dt) {
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

inline double BallsSimulation::go_by_events_towards(double t, long long most_events) {
  if (!reference_) throw NoClosedForm(time(), why_not_so_many);
  // So many that one can be heard in between.
  const auto pairs = static_cast<long long>(balls() * balls());
  const long long most = std::max(1LL, most_events / pairs);
  const double there = reference_->reach(t, most) ? t : reference_->piece_start();
  state_ = reference_->at(there);
  return there;
}

// ---- As plain numbers: how many balls, whether they came from a file, and the seed; masses,
// radii, positions, velocities; the start of balls from a file; what velocity Verlet or the
// reference carries.

inline std::vector<double> BallsSimulation::numbers() const {
  std::vector<double> all{static_cast<double>(balls()), own_balls_ ? 1.0 : 0.0,
                          static_cast<double>(seed_)};
  const auto append = [&all](const auto& matrix) {
    all.insert(all.end(), matrix.data(), matrix.data() + matrix.size());
  };
  append(scene_.mass);
  append(scene_.radius);
  append(state_.position);
  append(state_.velocity);
  if (own_balls_) {
    append(own_balls_->balls.position);
    append(own_balls_->balls.velocity);
  }
  if (method() == Method::velocity_verlet && verlet_.acceleration) append(*verlet_.acceleration);
  if (reference_) {
    all.push_back(reference_->next_step());
    all.push_back(reference_->piece_start());
    append(reference_->state_at_piece_start().position);
    append(reference_->state_at_piece_start().velocity);
    for (const double phase : reference_->contacts().phases()) all.push_back(phase);
  }
  return all;
}

inline bool BallsSimulation::recall_numbers(const std::vector<double>& all) {
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
inline bool BallsSimulation::recall_reference(std::span<const double> numbers) {
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
