#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "08_racket_game/exact/walk.hpp"
#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/game/round.hpp"
#include "08_racket_game/reference/racket_contacts.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "physics/components.hpp"
#include "run/saved_numbers.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Stage 8 as a simulation: a round of the game, or (`--player none`) the bare physics of a ball
/// and a racket in uniform motion.
class RacketRun final : public Simulation {
 public:
  using Ball = State<Eigen::Vector3d>;

  RacketRun() { reset_state(); }

  // ---- What pictures and players need to know
  const Settings& settings() const { return settings_; }
  const Round& round() const { return round_; }
  bool is_game() const { return settings_.player != PlayerKind::none; }
  bool is_replay() const { return replay_ != nullptr; }
  double gravity() const { return is_game() ? gravity_of(settings_, round_) : full().gravity; }
  Disc disc() const;
  double floor_height() const { return full().disc.centre.y() - rules::floor_below; }

  // ---- How it is played
  void play_as(PlayerKind player) { settings_.player = player; }
  void keep_best(int best) { round_.score.best = std::max(round_.score.best, best); }
  void set_assist(double percent) { settings_.assist = std::clamp(percent, 0.0, 100.0); }
  /// A human's input, once a frame.
  void want(Input input);
  /// Notes all inputs in `log`.
  void record(std::shared_ptr<InputLog> log) { record_ = std::move(log); }
  /// Plays the inputs of `log`, with what else is written there.
  void replay(std::shared_ptr<const InputLog> log);

  // ---- As every simulation
  std::unique_ptr<Simulation> clone() const override { return std::make_unique<RacketRun>(*this); }
  std::vector<Parameter> parameters() override;
  std::vector<Method> methods() const override;
  std::vector<std::string> columns() const override { return {"x", "y", "z", "vx", "vy", "vz"}; }
  std::vector<double> values() const override { return numbers_of(round_.ball); }
  std::vector<double> exact_values(double t) const override;
  std::optional<ContactNumbers> contact() const override;
  bool cuts_steps() const override { return true; }
  double pieces_per_step() const override;
  long long counted_force_evaluations() const override;
  std::string summary() const override;
  std::string stage_options() const override;
  void use_seed(std::uint64_t seed) override { settings_.seed = seed; }
  std::optional<StateError> error() const override;
  void place(const std::vector<double>& values) override;
  void parameters_changed() override;
  double next_event() const override;
  Energy energy() const override;
  // Of the bare physics; in the game, where nothing shows it, no book is kept.
  void keep_energy_book(bool keep) override { keep_book_ = keep; }
  double energy_before() const override;
  double energy_lost() const override;
  std::optional<double> exact_energy() const override;

 protected:
  void reset_state() override;
  void compare_from_here() override;
  void take_steps(long long count, double t, double dt) override;
  double go_by_events_towards(double t, long long most_events) override;
  bool is_finite() const override;
  std::vector<double> numbers() const override;
  bool recall_numbers(const std::vector<double>& all) override;

 private:
  const Racket& full() const { return settings_.racket; }

  /// The racket of the bare physics: at time 0, in uniform motion.
  Racket bare_scene() const;
  /// The same, seen from the racket: nothing in a contact depends on who watches.
  Racket scene_at_rest() const;
  std::optional<RacketReference> reference_from_here(double tolerance) const;

  Ball seen_from_racket(const Ball& ball, double t) const;
  Ball seen_from_ground(const Ball& ball, double t) const;

  /// Returns the number of new touches.
  long long move_ball(Racket& scene, double t, Ball& ball, double dt);
  void note_damper(const Racket& scene, double t, const Ball& before, const Ball& after, double dt);

  void game_step(double dt);
  void give(const Input& input);
  void note_settings();

  bool recall_reference(SavedNumbers& saved);
  bool recall_walk(SavedNumbers& saved);

  std::optional<Ball> exact_ball(double t) const;
  /// The closed form as far as it goes, and then the reference.
  std::optional<Ball> truth_at(double t) const;

  // A hand and a racket are followed in steps of 5 ms at most.
  static constexpr double longest_game_step = 5e-3;
  // Of the reference that others are compared with
  static constexpr double tightest = 1e-14;
  // A comparison is worth a second or two, not an hour.
  static constexpr long long most_events_of_truth = 5000000;

  Settings settings_;
  Eigen::Vector3d normal_{0, 1, 0};    // of the bare physics' racket, any length
  Eigen::Vector3d velocity_{0, 0, 0};  // m/s
  std::shared_ptr<InputLog> record_;
  std::shared_ptr<const InputLog> replay_;
  std::size_t next_entry_ = 0;

  Round round_;
  Ball from_racket_ = round_.ball;  // the bare physics' ball, seen from the racket
  long long pieces_ = 0;
  // The energy book of the bare physics: when it was opened, with what, and the damper's work since
  struct Book {
    double start = 0;   // s
    Ball ball;          // at the start
    double energy = 0;  // J, at the start
    double lost = 0;    // J
  };
  Book book_;
  bool keep_book_ = false;
  std::optional<RacketWalk> walk_;            // the movement, for `exact`
  std::optional<RacketReference> reference_;  // the same, for `reference`
  // What all others are compared with; the reference from the start on, once the rim is reached
  mutable std::optional<RacketWalk> truth_;
  std::optional<RacketReference> start_of_truth_;
  mutable std::optional<RacketReference> truth_at_rim_;
};

}  // namespace bounce
