#pragma once
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/components.hpp"
#include "physics/remembered.hpp"
#include "run/any_method.hpp"
#include "run/rows.hpp"
#include "run/simulation.hpp"
#include "run/truth.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

/// A scene and what belongs to it, to be run. One ball (one_ball_run.hpp), many balls and the
/// racket (stages 5 and 8) have one each. Besides:
///   take_steps(method, state, count, t, dt, book)
///   go_towards(method, t, most_events, state)      returns how far it came [s]
///   remembered(self, visit, state)        as in remembered.hpp: the state, and what else it has
///   more_evaluations(simulation)          besides those that the method counts; optional
template <class World, class Balls = State<typename World::Vector>>
concept WorldToRun = std::default_initializable<World> && std::copyable<World> &&
    requires(World& own, const World& world, const Simulation& run, double t, Balls& state,
             const EnergyBook& book) {
  typename World::Methods;    // a MethodList
  typename World::TruthWalk;  // what it is compared with
  { own.parameters() } -> std::same_as<std::vector<Parameter>>;
  { world.traits(run) } -> std::same_as<Traits>;
  { own.start(run.seed()) } -> std::same_as<Balls>;  // the state at t = 0
  own.place(t, state);  // a state that was put there, or parameters that changed
  requires std::same_as<decltype(own.truth(t, state)),
                        Truth<typename World::TruthWalk, typename World::Vector>>;
  { world.energy(t, state) } -> std::same_as<Energy>;
  // ... and before, with what a moving floor gave since then [J]
  { world.energy_before(book, true, t, state) } -> std::same_as<double>;
  { world.row(t, state) } -> std::same_as<std::vector<double>>;  // of the trace
};

/// A run, made of parts: a world, a method that moves it, the clock (of Simulation), a truth to
/// compare with, an energy book.
template <WorldToRun World>
class RunOf : public Simulation {
 public:
  using Vector = typename World::Vector;

  RunOf() : Simulation(first_method) { reset_state(); }

  World& world() { return world_; }
  const World& world() const { return world_; }
  template <class Its = World>
  const auto& scene() const {
    return static_cast<const Its&>(world_).scene;
  }
  const State<Vector>& state() const { return state_; }
  /// What the exact solution says at `t` (Truth).
  std::optional<State<Vector>> exact_state(double t) const { return truth_.at(t); }

  std::unique_ptr<Simulation> clone() const override { return std::make_unique<RunOf>(*this); }
  std::vector<Parameter> parameters() override { return world_.parameters(); }
  std::vector<Method> methods() const override { return AnyMethod<Methods>::offered(); }
  Traits traits() const override { return world_.traits(*this); }

  std::vector<double> values() const override { return world_.row(time(), state_); }
  Energy energy() const override { return world_.energy(time(), state_); }
  EnergyAccount energy_account() const override {
    const bool by_events = method().goes_by_events;
    EnergyAccount account{world_.energy_before(book_, by_events, time(), state_), book_.lost};
    // Without steps there is no book: what is missing was lost.
    if (by_events) account.lost = account.before - energy().total();
    if (const auto exact = exact_state(time()))
      account.exact = world_.energy(time(), *exact).total();
    return account;
  }
  long long counted_force_evaluations() const override {
    long long more = 0;
    if constexpr (requires { world_.more_evaluations(*this); })
      more = world_.more_evaluations(*this);
    return more + method_.counted_evaluations();
  }

  std::vector<double> exact_values(double t) const override {
    const std::optional<State<Vector>> exact = exact_state(t);
    return exact ? world_.row(t, *exact) : std::vector<double>{};
  }
  std::optional<StateError> error() const override {
    const std::optional<State<Vector>> exact = exact_state(time());
    if (!exact) return std::nullopt;
    return StateError{largest_distance(state_.position, exact->position),
                      largest_distance(state_.velocity, exact->velocity)};
  }

  void place(const std::vector<double>& values) override {
    read_rows(values, state_);
    parameters_changed();
  }
  void parameters_changed() override {
    world_.place(time(), state_);
    method_.begin(method(), world_, time(), state_, tolerance());
    method_.visit([this](auto& one) {
      if constexpr (requires { one.pass_event_at(0.0); }) one.pass_event_at(time());
    });
    compare_from_here();
  }
  double next_event() const override {
    return method_.visit([](const auto& one) {
      if constexpr (requires { one.next_event(); }) return one.next_event();
      return never;
    });
  }

 protected:
  void reset_state() override {
    state_ = world_.start(seed());
    parameters_changed();
  }
  void compare_from_here() override {
    truth_ = world_.truth(time(), state_);
    book_.open(energy().total());
  }

  bool take_steps(long long count, double t, double dt) override {
    method_.visit([&](auto& one) {
      if constexpr (!std::remove_reference_t<decltype(one)>::facts.goes_by_events) {
        world_.take_steps(one, state_, count, t, dt, book_);
      }
    });
    return is_finite();
  }
  double go_by_events_towards(double t, long long most_events) override {
    const double reached = method_.visit([&](auto& one) {
      if constexpr (std::remove_reference_t<decltype(one)>::facts.goes_by_events) {
        return world_.go_towards(one, t, most_events, state_);
      }
      return t;
    });
    if (!is_finite()) throw NonFinite(time());
    return reached;
  }

  std::vector<double> numbers() const override {
    NumberWriter writer;
    World::remembered(world_, writer, state_);
    method_.remembered(method_, writer);
    return writer.take();
  }
  std::string recall_numbers(const std::vector<double>& all) override {
    NumberReader reader(all);
    World::remembered(world_, reader, state_);
    if (const std::string what = reader.trouble_so_far(); !what.empty()) return what;
    method_.begin(method(), world_, time(), state_, tolerance());
    method_.remembered(method_, reader);
    if constexpr (requires { world_.seed; }) use_seed(world_.seed);
    const std::string what = reader.trouble();
    if (what.empty()) method_.resume();
    return what;
  }

 private:
  using Methods = typename World::Methods;

  bool is_finite() const {
    return bounce::is_finite(state_.position) && bounce::is_finite(state_.velocity);
  }

  World world_;
  State<Vector> state_{};
  AnyMethod<Methods> method_;
  mutable Truth<typename World::TruthWalk, Vector> truth_;
};

}  // namespace bounce
