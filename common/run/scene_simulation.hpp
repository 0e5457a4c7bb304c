#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/event_driven.hpp"
#include "physics/integrators.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Runs a one-dimensional scene (stages 1 to 3). `Exact` is the scene's movement in closed form,
/// made from the scene (the stage's exact.hpp).
template <class Scene, class Exact>
class SceneSimulation final : public Simulation {
 public:
  SceneSimulation() { reset_state(); }

  const Scene& scene() const { return scene_; }
  const State<double>& state() const { return state_; }

  /// What the exact solution says at `t`, from the last start or change of parameters on; `t` may
  /// lie a little before the simulation's time, for a smooth picture. Empty where the solution's
  /// events no longer advance time.
  std::optional<State<double>> exact_state(double t) const {
    try {
      const State<double> exact = truth_.at(std::max(t, truth_.last_event()));
      if (std::isfinite(exact.position) && std::isfinite(exact.velocity)) return exact;
    } catch (const TimeStandsStill&) {
    }
    return std::nullopt;
  }

  std::unique_ptr<Simulation> clone() const override {
    return std::make_unique<SceneSimulation>(*this);
  }
  std::vector<Parameter> parameters() override { return scene_.parameters(); }
  std::vector<Method> methods() const override {
    return {Method::explicit_euler, Method::semi_implicit_euler, Method::velocity_verlet,
            Method::rk4, Method::exact};
  }
  std::vector<std::string> columns() const override { return {"y", "v"}; }
  std::vector<double> values() const override { return {state_.position, state_.velocity}; }
  std::vector<double> exact_values(double t) const override {
    const std::optional<State<double>> exact = exact_state(t);
    return exact ? std::vector<double>{exact->position, exact->velocity} : std::vector<double>{};
  }
  std::optional<ContactNumbers> contact() const override {
    if constexpr (requires { scene_.stiffness; }) {
      double c = 0;
      if constexpr (requires { scene_.damping; }) c = scene_.damping;
      return ContactNumbers{natural_frequency(scene_.stiffness, scene_.mass),
                            damping_ratio(scene_.stiffness, c, scene_.mass)};
    } else {
      return std::nullopt;
    }
  }
  std::optional<StateError> error() const override {
    const std::optional<State<double>> exact = exact_state(time());
    if (!exact) return std::nullopt;
    return StateError{std::abs(state_.position - exact->position),
                      std::abs(state_.velocity - exact->velocity)};
  }

  void place(const std::vector<double>& values) override {
    state_ = {values.at(0), values.at(1)};
    parameters_changed();
  }
  void parameters_changed() override {
    walker_ = EventDriven<Exact>(Exact(scene_), time(), state_);
    verlet_.acceleration.reset();
    compare_from_here();
  }
  double next_event() const override {
    return method() == Method::exact ? walker_.next_event() : never;
  }

  Energy energy() const override { return scene_.energy(state_); }
  std::optional<double> exact_energy() const override {
    const std::optional<State<double>> exact = exact_state(time());
    if (!exact) return std::nullopt;
    return scene_.energy(*exact).total();
  }
  void keep_energy_book(bool keep) override { keep_book_ = keep; }
  double energy_before() const override { return energy_before_; }
  double energy_lost() const override {
    return method() == Method::exact ? energy_before_ - energy().total() : lost_;
  }

 protected:
  void reset_state() override {
    state_ = scene_.start;
    parameters_changed();
  }

  void compare_from_here() override {
    truth_ = EventDriven<Exact>(Exact(scene_), time(), state_);
    energy_before_ = energy().total();
    lost_ = 0;
  }

  void take_steps(long long count, double t, double dt) override {
    const auto loop = [&](auto&& step) {
      State<double> state = state_;  // a local copy can live in registers
      for (long long i = 0; i < count; ++i) {
        const double now = t + static_cast<double>(i) * dt;
        const State<double> before = state;
        step(scene_, now, state, dt);
        if (keep_book_) book(now, before, state, dt);
      }
      state_ = state;
    };
    using S = State<double>;
    switch (method()) {
      case Method::explicit_euler:
        return loop([](auto& s, double now, S& x, double h) { explicit_euler(s, now, x, h); });
      case Method::semi_implicit_euler:
        return loop([](auto& s, double now, S& x, double h) { semi_implicit_euler(s, now, x, h); });
      case Method::velocity_verlet:
        return loop(verlet_);
      case Method::rk4:
        return loop([](auto& s, double now, S& x, double h) { rk4(s, now, x, h); });
      case Method::exact:
        return;
    }
  }

  void move_exactly_to(double t) override { state_ = walker_.at(t); }

  bool is_finite() const override {
    return std::isfinite(state_.position) && std::isfinite(state_.velocity);
  }

  std::vector<double> numbers() const override {
    std::vector<double> all{state_.position, state_.velocity};
    if (method() == Method::velocity_verlet && verlet_.acceleration) {
      all.push_back(*verlet_.acceleration);
    }
    if (method() == Method::exact) {
      const State<double>& start = walker_.state_at_last_event();
      all.insert(all.end(), {walker_.last_event(), start.position, start.velocity,
                             static_cast<double>(walker_.phase())});
    }
    return all;
  }

  bool recall_numbers(const std::vector<double>& all) override {
    if (all.size() < 2) return false;
    const std::size_t own = all.size() - 2;
    state_ = {all[0], all[1]};
    switch (method()) {
      case Method::velocity_verlet:
        verlet_.acceleration.reset();
        if (own == 1) verlet_.acceleration = all[2];
        return own <= 1;
      case Method::exact:
        if (own != 4 || !(all[5] == 0 || all[5] == 1 || all[5] == 2)) return false;
        walker_.resume(all[2], {all[3], all[4]}, static_cast<Phase>(static_cast<int>(all[5])));
        return true;
      default:
        return own == 0;
    }
  }

 private:
  // The damper's work over one step, by the midpoint rule.
  void book(double t, const State<double>& before, const State<double>& after, double dt) {
    if constexpr (requires { scene_.damper_force(t, before); }) {
      const State<double> middle{(before.position + after.position) / 2,
                                 (before.velocity + after.velocity) / 2};
      lost_ -= scene_.damper_force(t + dt / 2, middle) * middle.velocity * dt;
    }
  }

  Scene scene_;
  State<double> state_ = scene_.start;
  VelocityVerlet<double> verlet_;
  EventDriven<Exact> walker_{Exact(scene_), 0, state_};         // the movement, for `exact`
  mutable EventDriven<Exact> truth_{Exact(scene_), 0, state_};  // what all others are compared with
  bool keep_book_ = false;
  double energy_before_ = 0;
  double lost_ = 0;
};

}  // namespace bounce
