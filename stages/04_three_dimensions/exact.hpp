#pragma once
#include <Eigen/Core>

#include "04_three_dimensions/three_dimensions.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven_in_space.hpp"

namespace bounce {

/// Stage 4 in closed form. No force mixes the directions, so there are three problems side by side:
/// up and down it is stage 3, and sideways the ball moves uniformly.
class ThreeDimensionsExact : public PhasesInSpace<ThreeDimensionsExact> {
  using Ball = State<Eigen::Vector3d>;

  /// Stage 3, if there is a floor.
  struct Upwards : BouncePhases {
    Phase phase_at(const State<double>& y) const {
      return floor ? BouncePhases::phase_at(y) : Phase::flight;
    }
    PhaseEnd end_of(Phase phase, const State<double>& y) const {
      return floor ? BouncePhases::end_of(phase, y) : PhaseEnd{never, Phase::flight};
    }
    bool floor;
  };

 public:
  explicit ThreeDimensionsExact(const ThreeDimensions& scene)
      : upwards{{scene.mass,
                 scene.gravity,
                 scene.radius,
                 {scene.stiffness, scene.damping, scene.contact}},
                scene.floor} {}

  // ---- The two parts of the movement (event_driven_in_space.hpp)
  const Upwards& bounce() const { return upwards; }
  State<double> along(const Ball& ball) const { return {ball.position.y(), ball.velocity.y()}; }
  Ball beside(Ball ball) const {
    ball.position.y() = ball.velocity.y() = 0;
    return ball;
  }
  Ball move_beside(const Ball& start, double t) const {
    return {start.position + start.velocity * t, start.velocity};
  }
  Ball together(Ball beside, const State<double>& y) const {
    beside.position.y() = y.position;
    beside.velocity.y() = y.velocity;
    return beside;
  }

  Eigen::Vector3d acceleration(Phase phase, double t, const Ball& ball) const {
    return {0, upwards.acceleration(phase, t, along(ball)), 0};
  }

 private:
  Upwards upwards;
};

}  // namespace bounce
