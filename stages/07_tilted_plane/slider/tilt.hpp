#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "app/demo.hpp"
#include "run/one_ball_run.hpp"

namespace bounce {

using TiltedPlaneRun = OneBallRun<TiltedPlane, TiltedPlaneExact>;

inline constexpr double degree = std::numbers::pi / 180;

/// How far the plane leans towards x [degrees].
inline double tilt(const Simulation& simulation) {
  const Plane plane = run_as<TiltedPlaneRun>(simulation).scene().plane();
  return std::atan2(plane.normal.x(), plane.normal.y()) / degree;
}

/// Turns plane and ball together about the z axis, so that a ball that lies on the plane stays on
/// it: whoever sits on the plane sees gravity turn.
inline void set_tilt(Simulation& simulation, double degrees) {
  const auto& run = run_as<TiltedPlaneRun>(simulation);
  const Eigen::AngleAxisd turn((tilt(run) - degrees) * degree, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d position = turn * run.state().position;
  const Eigen::Vector3d velocity = turn * run.state().velocity;
  const Eigen::Vector3d normal = turn * run.scene().normal;
  find_parameter(simulation.parameters(), "normal").set(to_text(components(normal)));
  simulation.place({position.x(), position.y(), position.z(),  //
                    velocity.x(), velocity.y(), velocity.z()});
}

/// A slider for it.
inline Dial tilt_dial() {
  return {"tilt",    "degrees", "turns plane and ball together; positive: downhill along x",
          {-30, 30}, tilt,      set_tilt};
}

}  // namespace bounce
