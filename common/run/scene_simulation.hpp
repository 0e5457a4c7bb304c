#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "physics/components.hpp"
#include "physics/event_driven.hpp"
#include "physics/integrators.hpp"
#include "physics/located_events.hpp"
#include "physics/one_ball.hpp"
#include "physics/reference.hpp"
#include "run/saved_numbers.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Runs a scene with one ball, in one dimension or three: what `Scene::start` says. `Exact` is the
/// scene's movement in closed form, made from the scene (the stage's exact.hpp). A scene whose
/// floor moves has a `floor_height(t)`, which the trace shows in a column of its own, an energy
/// that depends on the time, and `floor_power(t, state)`: what the moving floor gives to the ball.
template <class Scene, class Exact>
class SceneSimulation final : public Simulation {
 public:
  using Vector = decltype(Scene::start.position);  // double or Eigen::Vector3d

  SceneSimulation() { reset_state(); }

  const Scene& scene() const { return scene_; }
  const State<Vector>& state() const { return state_; }

  /// What the exact solution says at `t`, from the last start or change of parameters on; `t` may
  /// lie a little before the simulation's time, for a smooth picture. Empty where the solution's
  /// events no longer advance time, or are too many to follow.
  std::optional<State<Vector>> exact_state(double t) const {
    try {
      if (!truth_.reach(t, most_events_of_truth)) return std::nullopt;
      const State<Vector> exact = truth_.at(std::max(t, truth_.last_event()));
      if (all_finite(exact)) return exact;
    } catch (const TimeStandsStill&) {
    }
    return std::nullopt;
  }

  std::unique_ptr<Simulation> clone() const override {
    return std::make_unique<SceneSimulation>(*this);
  }
  std::vector<Parameter> parameters() override { return scene_.parameters(); }
  std::vector<Method> methods() const override {
    std::vector<Method> all{Method::explicit_euler, Method::semi_implicit_euler,
                            Method::velocity_verlet, Method::rk4};
    if (locates_events) {
      all.insert(all.end(), {Method::rk4_events, Method::flight_rk4, Method::reference});
    }
    all.push_back(Method::exact);
    return all;
  }
  long long counted_force_evaluations() const override {
    if constexpr (locates_events) {
      return method() == Method::reference ? reference_->force_evaluations()
                                           : located_.force_evaluations();
    }
    return 0;
  }
  std::vector<std::string> columns() const override {
    if constexpr (floor_moves) {
      return {"floor", "y", "v"};
    } else if constexpr (dimensions == 1) {
      return {"y", "v"};
    } else {
      return {"x", "y", "z", "vx", "vy", "vz"};
    }
  }
  std::vector<double> values() const override { return row(time(), state_); }
  std::vector<double> exact_values(double t) const override {
    const std::optional<State<Vector>> exact = exact_state(t);
    return exact ? row(t, *exact) : std::vector<double>{};
  }
  std::optional<ContactNumbers> contact() const override {
    if constexpr (requires { scene_.floor; }) {
      if (!scene_.floor) return std::nullopt;
    }
    if constexpr (requires { scene_.stiffness; }) {
      double c = 0;
      if constexpr (requires { scene_.damping; }) c = scene_.damping;
      return ContactNumbers{natural_frequency(scene_.stiffness, scene_.mass),
                            damping_ratio(scene_.stiffness, c, scene_.mass)};
    } else {
      return std::nullopt;
    }
  }
  double swing_rate() const override {
    if constexpr (floor_moves) return scene_.amplitude > 0 ? scene_.angular_frequency : 0;
    return 0;
  }
  std::optional<StateError> error() const override {
    const std::optional<State<Vector>> exact = exact_state(time());
    if (!exact) return std::nullopt;
    return StateError{distance_between(state_.position, exact->position),
                      distance_between(state_.velocity, exact->velocity)};
  }

  void place(const std::vector<double>& values) override {
    state_ = SavedNumbers(std::span(values).last(2 * dimensions)).template state<Vector>();
    parameters_changed();
  }
  void parameters_changed() override {
    walker_ = Walker(Exact(scene_), time(), state_);
    if (method() == Method::exact) walker_.reach(time(), 1);  // a start on the touch begins with it
    located_ = Located(Exact(scene_), time(), state_);
    if constexpr (locates_events) reference_.emplace(fresh_reference());
    verlet_.acceleration.reset();
    compare_from_here();
  }
  double next_event() const override {
    if constexpr (locates_events) {
      if (method() == Method::reference) return reference_->next_event();
    }
    return method() == Method::exact ? walker_.next_event() : never;
  }

  Energy energy() const override { return energy_of(state_); }
  std::optional<double> exact_energy() const override {
    const std::optional<State<Vector>> exact = exact_state(time());
    if (!exact) return std::nullopt;
    return energy_of(*exact).total();
  }
  void keep_energy_book(bool keep) override { keep_book_ = keep; }
  double energy_before() const override {
    return floor_moves && goes_by_events(method()) ? energy().total() : energy_before_;
  }
  double energy_lost() const override {
    // Without steps there is no book. Beside a floor at rest, what is missing was lost; what a
    // moving floor gave and the damper took cannot be told apart.
    if (goes_by_events(method())) return energy_before() - energy().total();
    return lost_;
  }

 protected:
  void reset_state() override {
    state_ = scene_.start;
    parameters_changed();
  }

  void compare_from_here() override {
    truth_ = Walker(Exact(scene_), time(), state_);
    energy_before_ = energy().total();
    lost_ = 0;
  }

  void take_steps(long long count, double t, double dt) override {
    const auto loop = [&](auto&& step) {
      // Local copies can live in registers, and what follows from the scene alone is computed once.
      const Scene scene = scene_;
      State<Vector> state = state_;
      for (long long i = 0; i < count; ++i) {
        const double now = t + static_cast<double>(i) * dt;
        const State<Vector> before = state;
        step(scene, now, state, dt);
        if (keep_book_) book(now, before, state, dt);
      }
      state_ = state;
    };
    using S = State<Vector>;
    switch (method()) {
      case Method::explicit_euler:
        return loop([](auto& s, double now, S& x, double h) { explicit_euler(s, now, x, h); });
      case Method::semi_implicit_euler:
        return loop([](auto& s, double now, S& x, double h) { semi_implicit_euler(s, now, x, h); });
      case Method::velocity_verlet:
        return loop(verlet_);
      case Method::rk4:
        return loop([](auto& s, double now, S& x, double h) { rk4(s, now, x, h); });
      case Method::rk4_events:
      case Method::flight_rk4:
        if constexpr (locates_events) take_located_steps(count, t, dt);
        return;
      case Method::reference:
      case Method::exact:
        return;
    }
  }

  double go_by_events_towards(double t, long long most_events) override {
    if constexpr (locates_events) {
      if (method() == Method::reference) {
        const double there = reference_->reach(t, most_events) ? t : reference_->piece_start();
        state_ = reference_->at(there);
        return there;
      }
    }
    const double reached = walker_.reach(t, most_events) ? t : walker_.last_event();
    state_ = walker_.at(reached);
    return reached;
  }

  bool is_finite() const override { return all_finite(state_); }

  std::vector<double> numbers() const override {
    std::vector<double> all = numbers_of(state_);
    if (method() == Method::velocity_verlet && verlet_.acceleration) {
      append(all, *verlet_.acceleration);
    }
    if (method() == Method::exact) append_walker(all);
    if constexpr (locates_events) {
      if (is_located()) {
        append_phase(all, located_.phase_start(), located_.state_at_phase_start(),
                     located_.phase());
      } else if (method() == Method::reference) {
        all.push_back(reference_->next_step());
        append_phase(all, reference_->piece_start(), reference_->state_at_piece_start(),
                     reference_->contacts().phase());
      }
    }
    return all;
  }

  bool recall_numbers(const std::vector<double>& all) override {
    SavedNumbers saved(all);
    state_ = saved.template state<Vector>();
    switch (method()) {
      case Method::velocity_verlet:
        verlet_.acceleration.reset();
        if (saved.left() > 0) verlet_.acceleration = saved.template vector<Vector>();
        return saved.all_is_well();
      case Method::rk4_events:
      case Method::flight_rk4:
        return recall_located(saved);
      case Method::reference:
        return recall_reference(saved);
      case Method::exact:
        return recall_walker(saved);
      default:
        return saved.all_is_well();
    }
  }

 private:
  using Walker = EventDriven<Exact, Vector>;
  // Does the walker go along the contact's direction only (event_driven_in_space.hpp)?
  static constexpr bool splits = requires(const Walker& walker) { walker.beside_at_start(); };
  static constexpr bool floor_moves = requires(const Scene& scene) { scene.floor_height(0.0); };

  // Does the closed form also tell what located events need?
  static constexpr bool locates_events = requires(const Exact& exact) { exact.after_touch(); };
  struct NoLocatedEvents {
    NoLocatedEvents(const Exact&, double, const State<Vector>&) {}
  };
  using Located = std::conditional_t<locates_events, LocatedEvents<Exact, Vector>, NoLocatedEvents>;
  struct NoReference {};
  using HighOrder = Reference<OneBall<Exact, Vector>, Vector>;
  HighOrder fresh_reference() const {
    return {{Exact(scene_), time(), state_}, time(), state_, tolerance()};
  }
  bool is_located() const {
    return method() == Method::rk4_events || method() == Method::flight_rk4;
  }

  void take_located_steps(long long count, double t, double dt) {
    const auto rk4_step = [](auto& law, double now, State<Vector>& x, double h) {
      rk4(law, now, x, h);
    };
    const auto time_of = [&](long long i) { return t + static_cast<double>(i) * dt; };
    for (long long i = 0; i < count; ++i) {
      const double now = time_of(i);
      const State<Vector> before = state_;
      if (method() == Method::rk4_events) {
        located_(rk4_step, now, state_, time_of(i + 1));
      } else {
        // Whole steps of flight at a stroke; the energy book wants them one by one.
        if (!keep_book_) i += located_.steps_in_flight(now, dt, count - 1 - i);
        located_.with_flights_by_formula(rk4_step, now, state_, time_of(i + 1));
      }
      if (keep_book_) book(now, before, state_, dt);
    }
  }
  // A comparison is worth a second or two, not an hour.
  static constexpr long long most_events_of_truth = 10000000;
  static constexpr std::size_t dimensions = sizeof(Vector) / sizeof(double);

  Energy energy_of(const State<Vector>& state) const {
    if constexpr (floor_moves) {
      return scene_.energy(time(), state);
    } else {
      return scene_.energy(state);
    }
  }

  // What the trace shows of a state at `t`.
  std::vector<double> row(double t, const State<Vector>& state) const {
    std::vector<double> all = numbers_of(state);
    if constexpr (floor_moves) all.insert(all.begin(), scene_.floor_height(t));
    return all;
  }

  // ---- The phase that a method is in, as plain numbers: when it began, with what, and which it is
  template <class At>
  static void append_phase(std::vector<double>& all, double start, const At& at_start,
                           Phase phase) {
    all.push_back(start);
    append(all, at_start);
    all.push_back(static_cast<double>(phase));
  }
  void append_walker(std::vector<double>& all) const {
    if constexpr (splits) {
      all.push_back(walker_.start());
      append(all, walker_.beside_at_start());
      append_phase(all, walker_.last_event(), walker_.along_at_last_event(), walker_.phase());
    } else {
      append_phase(all, walker_.last_event(), walker_.state_at_last_event(), walker_.phase());
    }
  }
  bool recall_walker(SavedNumbers& saved) {
    if constexpr (splits) {
      const double start = saved.number();
      const State<Vector> beside = saved.template state<Vector>();
      const double since = saved.number();
      const State<double> along = saved.state<double>();
      const Phase phase = saved.phase();
      if (saved.all_is_well()) walker_.resume(start, beside, since, along, phase);
    } else {
      const double since = saved.number();
      const State<Vector> at_start = saved.template state<Vector>();
      const Phase phase = saved.phase();
      if (saved.all_is_well()) walker_.resume(since, at_start, phase);
    }
    return saved.all_is_well();
  }
  bool recall_located(SavedNumbers& saved) {
    const double since = saved.number();
    const State<Vector> at_start = saved.template state<Vector>();
    const Phase phase = saved.phase();
    if constexpr (locates_events) {
      if (saved.all_is_well()) located_.resume(since, at_start, phase);
    }
    return saved.all_is_well();
  }
  bool recall_reference(SavedNumbers& saved) {
    const double next_step = saved.positive();
    const double since = saved.number();
    const State<Vector> at_start = saved.template state<Vector>();
    const Phase phase = saved.phase();
    if constexpr (locates_events) {
      if (saved.all_is_well()) {
        reference_.emplace(fresh_reference());
        reference_->resume({Exact(scene_), phase}, since, at_start, next_step);
      }
    }
    return saved.all_is_well();
  }

  static bool all_finite(const State<Vector>& state) {
    return bounce::is_finite(state.position) && bounce::is_finite(state.velocity);
  }

  // The damper's work over one step, and the moving floor's, by the midpoint rule.
  void book(double t, const State<Vector>& before, const State<Vector>& after, double dt) {
    [[maybe_unused]] const State<Vector> middle{(before.position + after.position) / 2,
                                                (before.velocity + after.velocity) / 2};
    if constexpr (floor_moves) {
      const Energy energy = scene_.energy(t, before);
      if (energy.spring == 0 && scene_.energy(t + dt, after).spring > 0) {  // a touch: a new page
        energy_before_ = energy.total();
        lost_ = 0;
      }
      energy_before_ += scene_.floor_power(t + dt / 2, middle) * dt;
      lost_ += scene_.damper_power(t + dt / 2, middle) * dt;
    } else if constexpr (requires { scene_.damper_force(t, before); }) {
      lost_ -= dot(scene_.damper_force(t + dt / 2, middle), middle.velocity) * dt;
    }
  }

  Scene scene_;
  State<Vector> state_ = scene_.start;
  VelocityVerlet<Vector> verlet_;
  Walker walker_{Exact(scene_), 0, state_};    // the movement, for `exact`
  Located located_{Exact(scene_), 0, state_};  // for methods that step but locate events
  std::conditional_t<locates_events, std::optional<HighOrder>, NoReference> reference_;
  mutable Walker truth_{Exact(scene_), 0, state_};  // what all others are compared with
  bool keep_book_ = false;
  double energy_before_ = 0;
  double lost_ = 0;
};

}  // namespace bounce
