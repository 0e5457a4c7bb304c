#pragma once
#include <Eigen/Core>
#include <type_traits>

#include "physics/energy.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The forces on a ball, one by one [N].
template <class Vector>
struct Forces {
  Vector gravity, spring, damper;
};

/// The parts of scene.force(t, state), for arrows and for the energy book. Gravity and spring are
/// known; whatever else the scene's own law says is the damper's: in a push-only contact that has
/// let go, that takes all of the spring's force away.
template <class Scene, class Vector>
Forces<Vector> forces_of(const Scene& scene, double t, const State<Vector>& state) {
  Forces<Vector> forces{};
  const double weight = scene.mass * scene.gravity;
  if constexpr (std::is_same_v<Vector, double>) {
    forces.gravity = -weight;
  } else {
    forces.gravity = Eigen::Vector3d(0, -weight, 0);
    forces.spring.setZero();
  }
  if constexpr (requires { scene.spring_force(t, state); }) {
    forces.spring = scene.spring_force(t, state);
  }
  forces.damper = scene.force(t, state) - forces.gravity - forces.spring;
  return forces;
}

/// The scene's energy [J]. Only where a floor moves does it depend on the time.
template <class Scene, class Vector>
Energy energy_of(const Scene& scene, double t, const State<Vector>& state) {
  if constexpr (requires { scene.energy(t, state); }) {
    return scene.energy(t, state);
  } else {
    return scene.energy(state);
  }
}

}  // namespace bounce
