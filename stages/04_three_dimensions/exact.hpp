#pragma once
#include <Eigen/Core>

#include "physics/closed_form.hpp"
#include "three_dimensions.hpp"

namespace bounce {

/// Stage 4 in closed form. No force mixes the directions, so there are three problems side by side:
/// up and down it is stage 3, and sideways the ball moves uniformly.
struct ThreeDimensionsExact {
  explicit ThreeDimensionsExact(const ThreeDimensions& scene)
      : upwards{scene.mass,
                scene.gravity,
                scene.radius,
                {scene.stiffness, scene.damping, scene.contact}},
        floor(scene.floor) {}

  Phase phase_at(const State<Eigen::Vector3d>& state) const {
    return floor ? upwards.phase_at(along_y(state)) : Phase::flight;
  }
  State<Eigen::Vector3d> move(Phase phase, const State<Eigen::Vector3d>& start, double t) const {
    return with_y(sideways(start, t), upwards.move(phase, along_y(start), t));
  }
  PhaseEnd end_of(Phase phase, const State<Eigen::Vector3d>& start) const {
    return floor ? upwards.end_of(phase, along_y(start)) : PhaseEnd{never, Phase::flight};
  }
  State<Eigen::Vector3d> arrive(const State<Eigen::Vector3d>& start, const PhaseEnd& end) const {
    return with_y(sideways(start, end.after), upwards.arrive(along_y(start), end));
  }
  State<Eigen::Vector3d> at_event(Phase before, Phase after,
                                  const State<Eigen::Vector3d>& state) const {
    return with_y(state, upwards.at_event(before, after, along_y(state)));
  }

 private:
  static State<Eigen::Vector3d> sideways(const State<Eigen::Vector3d>& start, double t) {
    return {start.position + start.velocity * t, start.velocity};
  }
  static State<double> along_y(const State<Eigen::Vector3d>& state) {
    return {state.position.y(), state.velocity.y()};
  }
  static State<Eigen::Vector3d> with_y(State<Eigen::Vector3d> state, const State<double>& y) {
    state.position.y() = y.position;
    state.velocity.y() = y.velocity;
    return state;
  }

  BouncePhases upwards;
  bool floor;
};

}  // namespace bounce
