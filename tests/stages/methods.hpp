#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "physics/methods/stepping_methods.hpp"

namespace bounce::test {

/// A stepping method under its name; every call of `make` gives a fresh one.
template <class Scene>
struct NamedMethod {
  using Step = std::function<void(const Scene&, double, State<double>&, double)>;
  std::string name;
  std::function<Step()> make;
};

template <class Scene>
std::vector<NamedMethod<Scene>> all_methods() {
  using Step = typename NamedMethod<Scene>::Step;
  return {{"explicit-euler", [] { return Step(explicit_euler<Scene, double>); }},
          {"semi-implicit-euler", [] { return Step(semi_implicit_euler<Scene, double>); }},
          {"velocity-verlet", [] { return Step(VelocityVerlet<double>{}); }},
          {"rk4", [] { return Step(rk4<Scene, double>); }}};
}

/// The state after `steps` steps of `dt` from the scene's start.
template <class Scene>
State<double> run(const Scene& scene, const NamedMethod<Scene>& method, double dt, int steps) {
  State<double> state = scene.start;
  const auto step = method.make();
  for (int i = 0; i < steps; ++i) step(scene, i * dt, state, dt);
  return state;
}

/// Slope of log(error) against log(dt) by least squares.
inline double fitted_slope(const std::vector<double>& dt, const std::vector<double>& error) {
  double mx = 0, my = 0, sxy = 0, sxx = 0;
  const auto n = static_cast<double>(dt.size());
  for (std::size_t i = 0; i < dt.size(); ++i)
    mx += std::log(dt[i]) / n, my += std::log(error[i]) / n;
  for (std::size_t i = 0; i < dt.size(); ++i) {
    sxy += (std::log(dt[i]) - mx) * (std::log(error[i]) - my);
    sxx += (std::log(dt[i]) - mx) * (std::log(dt[i]) - mx);
  }
  return sxy / sxx;
}

}  // namespace bounce::test
