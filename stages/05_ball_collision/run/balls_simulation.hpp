#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "05_ball_collision/ball_collision.hpp"
#include "05_ball_collision/reference/ball_truth.hpp"
#include "05_ball_collision/scenes/scenes.hpp"
#include "many_balls/lammps_import.hpp"
#include "many_balls/many_balls.hpp"
#include "physics/integrators.hpp"
#include "run/options.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Runs the balls of a built-in scene, or those of a file.
class BallsSimulation final : public Simulation {
 public:
  using Balls = State<Eigen::Matrix3Xd>;

  BallsSimulation();

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
  many::Laws laws() const;
  /// The option `--threads`: for many balls (below). The result is the same, to the bit.
  void use_threads(int threads) { threads_ = threads; }
  /// From so many balls on, the steps of semi-implicit Euler and velocity Verlet are taken by
  /// many::ManyBalls, which is faster (see the lesson) and gives the same bits.
  void use_many_from(Eigen::Index count) { many_from_ = count; }

  std::unique_ptr<Simulation> clone() const override;
  std::vector<Parameter> parameters() override;
  std::vector<Method> methods() const override;
  void check_method() const override;
  std::vector<std::string> columns() const override;
  std::size_t balls() const override { return static_cast<std::size_t>(scene_.mass.size()); }
  std::vector<double> values() const override { return rows_of(state_); }
  std::string stage_options() const override;
  std::optional<ContactNumbers> contact() const override;

  void use_seed(std::uint64_t seed) override { seed_ = seed; }
  void place(const std::vector<double>& values) override;
  void parameters_changed() override;

  Energy energy() const override;
  void keep_energy_book(bool keep) override { keep_book_ = keep; }
  double energy_before() const override { return energy_before_; }
  double energy_lost() const override;

  // There is no formula for many balls, but for a few there is the reference.
  std::vector<double> exact_values(double t) const override;
  std::optional<StateError> error() const override;  // of the ball that is off most
  std::optional<double> exact_energy() const override;

  double next_event() const override;
  long long counted_force_evaluations() const override;

 protected:
  void reset_state() override;
  void compare_from_here() override;
  void take_steps(long long count, double t, double dt) override;
  double go_by_events_towards(double t, long long most_events) override;
  bool is_finite() const override;
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
  BallReference fresh_reference() const;

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

}  // namespace bounce
