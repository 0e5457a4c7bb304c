#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/game/round.hpp"
#include "run/any_method.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

/// A round of the game as a simulation. A player's hands move the racket, so that nothing is known
/// beforehand: there is no exact solution to compare with, and no energy book.
class GameRun final : public Simulation {
 public:
  using Ball = State<Eigen::Vector3d>;

  GameRun() : Simulation(first_method) { reset_state(); }

  // ---- What pictures and players need to know
  const Settings& settings() const { return settings_; }
  const Round& round() const { return round_; }
  bool is_replay() const { return replay_ != nullptr; }
  double gravity() const { return gravity_of(settings_, round_); }
  Disc disc() const { return disc_of(settings_, round_); }
  /// The racket as it is now, with the ball on its present side.
  Racket scene_now() const { return scene_of(settings_, round_, disc()); }
  double floor_height() const { return settings_.racket.disc.centre.y() - rules::floor_below; }

  // ---- How it is played
  void play_as(PlayerKind player) { settings_.player = player; }
  /// The best points that are known, of this mode with this assist.
  void use_best(int best) { round_.points.best = std::max(best, round_.points.total); }
  /// The next of the three modes; the next round, which must be begun, is in it.
  void use_next_mode();
  void set_assist(double percent) { settings_.assist = std::clamp(percent, 0.0, 100.0); }
  /// A human's input, once a frame.
  void want(Input input);
  /// Notes all inputs in `log`.
  void record(std::shared_ptr<InputLog> log) { record_ = std::move(log); }
  bool is_recorded() const { return record_ != nullptr; }
  /// Plays the inputs of `log`, with what else is written there.
  void replay(std::shared_ptr<const InputLog> log);
  /// A copy of a run that went on: what its player did since comes again, and is not noted twice.
  void repeat();

  // ---- As every simulation
  std::unique_ptr<Simulation> clone() const override { return std::make_unique<GameRun>(*this); }
  std::vector<Parameter> parameters() override { return settings_.parameters(); }
  std::vector<Method> methods() const override;
  Traits traits() const override;
  std::vector<double> values() const override;
  Energy energy() const override { return scene_now().energy(0, round_.ball); }
  EnergyAccount energy_account() const override { return {energy().total(), 0}; }
  long long counted_force_evaluations() const override {
    return more_pieces_ * method().evaluations + method_.counted_evaluations();
  }
  void place(const std::vector<double>& values) override;
  void parameters_changed() override;

 protected:
  void reset_state() override;
  bool take_steps(long long count, double t, double dt) override;
  std::vector<double> numbers() const override;
  std::string recall_numbers(const std::vector<double>& all) override;

 private:
  using Methods = SteppingMethods<Eigen::Vector3d>;

  void one_step(double dt);
  void give(const Input& input);
  void note_settings();
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit);

  // A hand and a racket are followed in steps of 5 ms at most.
  static constexpr double longest_step = 5e-3;

  Settings settings_;
  Round round_;
  AnyMethod<Methods> method_;
  long long more_pieces_ = 0;  // of contact, than there were steps
  std::shared_ptr<InputLog> record_;
  std::shared_ptr<const InputLog> replay_;
  std::size_t next_entry_ = 0;
};

}  // namespace bounce
