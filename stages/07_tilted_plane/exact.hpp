#pragma once
#include <Eigen/Core>

#include "07_tilted_plane/tilted_plane.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven_in_space.hpp"

namespace bounce {

/// Stage 7 in closed form. Along the normal it is stage 3 with gravity's normal component. Along
/// the plane nothing acts but gravity's other component: the foot of the ball, the point of the
/// plane nearest to it, is uniformly accelerated.
class TiltedPlaneExact : public PhasesInSpace<TiltedPlaneExact> {
  using Ball = State<Eigen::Vector3d>;

 public:
  explicit TiltedPlaneExact(const TiltedPlane& scene)
      : plane(scene.plane()),
        along_normal{scene.mass,
                     scene.gravity * plane.normal.y(),
                     scene.radius,
                     {scene.stiffness, scene.damping, scene.contact}} {
    const Eigen::Vector3d gravity(0, -scene.gravity, 0);
    downhill = gravity - dot(plane.normal, gravity) * plane.normal;
  }

  // ---- The two parts of the movement (event_driven_in_space.hpp)
  const BouncePhases& bounce() const { return along_normal; }
  /// Distance from the plane, and velocity away from it.
  State<double> along(const Ball& ball) const {
    return {plane.distance(ball.position), dot(plane.normal, ball.velocity)};
  }
  /// The rest: the foot, and its velocity.
  Ball beside(const Ball& ball) const {
    const auto [distance, speed] = along(ball);
    return {ball.position - distance * plane.normal, ball.velocity - speed * plane.normal};
  }
  Ball move_beside(const Ball& foot, double t) const { return fly(foot, downhill, t); }
  Ball together(const Ball& foot, const State<double>& along) const {
    return {foot.position + along.position * plane.normal,
            foot.velocity + along.velocity * plane.normal};
  }

  Eigen::Vector3d acceleration(Phase phase, double t, const Ball& ball) const {
    return downhill + along_normal.acceleration(phase, t, along(ball)) * plane.normal;
  }

 private:
  Plane plane;
  BouncePhases along_normal;
  Eigen::Vector3d downhill;  // gravity along the plane [m/s^2]
};

}  // namespace bounce
