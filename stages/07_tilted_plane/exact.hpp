#pragma once
#include <Eigen/Core>
#include <array>

#include "physics/closed_form.hpp"
#include "tilted_plane.hpp"

namespace bounce {

/// Stage 7 in closed form. Along the normal it is stage 3 with gravity's normal component. Along
/// the plane nothing acts but gravity's other component: the foot of the ball, the point of the
/// plane nearest to it, is uniformly accelerated.
struct TiltedPlaneExact {
  explicit TiltedPlaneExact(const TiltedPlane& scene)
      : plane(scene.plane()),
        along_normal{scene.mass,
                     scene.gravity * plane.normal.y(),
                     scene.radius,
                     {scene.stiffness, scene.damping, scene.contact}} {
    const Eigen::Vector3d gravity(0, -scene.gravity, 0);
    downhill = gravity - plane.normal.dot(gravity) * plane.normal;
  }

  Phase phase_at(const State<Eigen::Vector3d>& state) const {
    return along_normal.phase_at(normal_part(state));
  }
  State<Eigen::Vector3d> move(Phase phase, const State<Eigen::Vector3d>& start, double t) const {
    return above(slide(foot_of(start), t), along_normal.move(phase, normal_part(start), t));
  }
  State<Eigen::Vector3d> arrive(const State<Eigen::Vector3d>& start, const PhaseEnd& end) const {
    return above(slide(foot_of(start), end.after), along_normal.arrive(normal_part(start), end));
  }
  PhaseEnd end_of(Phase phase, const State<Eigen::Vector3d>& start) const {
    return along_normal.end_of(phase, normal_part(start));
  }
  State<Eigen::Vector3d> at_event(Phase before, Phase after,
                                  const State<Eigen::Vector3d>& state) const {
    return above(foot_of(state), along_normal.at_event(before, after, normal_part(state)));
  }

  // For methods that step but locate events
  Eigen::Vector3d acceleration(Phase phase, double t, const State<Eigen::Vector3d>& state) const {
    return downhill + along_normal.acceleration(phase, t, normal_part(state)) * plane.normal;
  }
  Lasting touch_lasts(Phase next, double t, const State<Eigen::Vector3d>& state) const {
    return along_normal.touch_lasts(next, t, normal_part(state));
  }
  std::array<Phase, 1> after_touch() const { return along_normal.after_touch(); }
  double time_scale() const { return along_normal.time_scale(); }
  double max_bend(Phase next, double t, const State<Eigen::Vector3d>& state, double window) const {
    return along_normal.max_bend(next, t, normal_part(state), window);
  }

 private:
  /// Distance from the plane, and velocity away from it.
  State<double> normal_part(const State<Eigen::Vector3d>& state) const {
    return {plane.distance(state.position), plane.normal.dot(state.velocity)};
  }
  /// The rest: the point of the plane below the ball, and its velocity.
  State<Eigen::Vector3d> foot_of(const State<Eigen::Vector3d>& state) const {
    const auto [distance, speed] = normal_part(state);
    return {state.position - distance * plane.normal, state.velocity - speed * plane.normal};
  }
  State<Eigen::Vector3d> slide(State<Eigen::Vector3d> foot, double t) const {
    foot.position += (foot.velocity + downhill * (t / 2)) * t;
    foot.velocity += downhill * t;
    return foot;
  }
  State<Eigen::Vector3d> above(const State<Eigen::Vector3d>& foot,
                               const State<double>& normal_part) const {
    return {foot.position + normal_part.position * plane.normal,
            foot.velocity + normal_part.velocity * plane.normal};
  }

  Plane plane;
  BouncePhases along_normal;
  Eigen::Vector3d downhill;  // gravity along the plane [m/s^2]
};

}  // namespace bounce
