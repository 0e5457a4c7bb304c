#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/components.hpp"
#include "physics/methods/semi_implicit_euler.hpp"
#include "run/save_load.hpp"

namespace bounce::test {

/// Parameters by name, as after --set: {{"damping", "2"}, {"contact", "push-only"}}.
using Values = std::vector<std::pair<std::string, std::string>>;

inline void set(Simulation& run, const std::string& name, const std::string& value) {
  find_parameter(run.parameters(), name).set(value);
}

/// Sets all of them, and the way of moving time, and starts anew.
inline void set_up(Simulation& run, const Values& settings,
                   Method method = methods::semi_implicit_euler, double dt = 1e-3) {
  for (const auto& [name, value] : settings) set(run, name, value);
  run.use_method(method);
  run.use_dt(dt);
  run.restart();
}

/// A run of this class from the start that the settings give.
template <class Run>
Run run_with(const Values& settings, Method method = methods::semi_implicit_euler,
             double dt = 1e-3) {
  Run run;
  set_up(run, settings, method, dt);
  return run;
}

/// The run that was saved there.
template <class Run>
Run loaded(const std::string& path, const StageName& stage) {
  std::unique_ptr<Simulation> run = std::make_unique<Run>();
  load_state(path, stage, {}, run);
  return run_as<Run>(*run);
}

/// As --set takes it: "0.1,0.9,-0.3".
inline std::string text(const Eigen::Vector3d& vector) { return to_text(components(vector)); }

}  // namespace bounce::test
