#pragma once
#include <Eigen/Core>
#include <array>

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

  // For methods that step but locate events
  Eigen::Vector3d acceleration(Phase phase, double t, const State<Eigen::Vector3d>& state) const {
    return {0, upwards.acceleration(phase, t, along_y(state)), 0};
  }
  Lasting touch_lasts(Phase next, double t, const State<Eigen::Vector3d>& state) const {
    return upwards.touch_lasts(next, t, along_y(state));
  }
  std::array<Phase, 1> after_touch() const { return upwards.after_touch(); }
  double time_scale() const { return upwards.time_scale(); }
  double max_bend(Phase next, double t, const State<Eigen::Vector3d>& state, double window) const {
    return upwards.max_bend(next, t, along_y(state), window);
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
