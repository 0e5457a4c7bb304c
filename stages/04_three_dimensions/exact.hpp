#pragma once
#include <Eigen/Core>
#include <array>

#include "04_three_dimensions/three_dimensions.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven_in_space.hpp"

namespace bounce {

/// Stage 4 in closed form. No force mixes the directions, so there are three problems side by side:
/// up and down it is stage 3, and sideways the ball moves uniformly.
class ThreeDimensionsExact {
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

  // ---- For methods that step, but locate events or fly by formula
  Phase phase_at(const Ball& ball) const { return upwards.phase_at(along(ball)); }
  Ball move(Phase phase, const Ball& start, double t) const {
    return together(move_beside(start, t), upwards.move(phase, along(start), t));
  }
  PhaseEnd end_of(Phase phase, const Ball& start) const {
    return upwards.end_of(phase, along(start));
  }
  Ball at_event(Phase before, Phase after, const Ball& ball) const {
    return together(ball, upwards.at_event(before, after, along(ball)));
  }
  Eigen::Vector3d acceleration(Phase phase, double t, const Ball& ball) const {
    return {0, upwards.acceleration(phase, t, along(ball)), 0};
  }
  EventValue event_value(Phase next, double t, const Ball& ball) const {
    return upwards.event_value(next, t, along(ball));
  }
  std::array<Phase, 1> after_touch() const { return upwards.after_touch(); }
  double time_scale() const { return upwards.time_scale(); }
  double max_bend(Phase next, double t, const Ball& ball, double window) const {
    return upwards.max_bend(next, t, along(ball), window);
  }

 private:
  Upwards upwards;
};

}  // namespace bounce
