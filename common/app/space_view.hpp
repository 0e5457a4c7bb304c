#pragma once
#include <Eigen/Core>
#include <functional>

#include "app/camera.hpp"
#include "app/canvas.hpp"
#include "app/demo.hpp"
#include "app/playback.hpp"
#include "physics/forces.hpp"
#include "physics/shapes.hpp"
#include "physics/state.hpp"
#include "run/one_ball_run.hpp"
#include "run/rows.hpp"

namespace bounce {

/// What the view in space needs to know of the ball and the plane it bounces on.
struct BallInSpace {
  double radius = 0.1;                                                                          // m
  std::function<Forces<Eigen::Vector3d>(double t, const State<Eigen::Vector3d>&)> forces = {};  // N
  Plane plane = {};
  bool has_plane = true;
  bool landings = false;  // mark where it touched, with the distances between the marks
  Eigen::Vector3d look_at{1.1, 0.55, 0.4};  // the middle of the picture at first [m]
  double room = 1.3;                        // the camera follows a ball further away than this [m]
  double distance = 4.3;                    // of the camera from what it looks at [m]
};

/// What looks at it, in that part of the window.
Camera camera_for(const Playback& playback, const BallInSpace& ball, Rect area, bool from_above);

/// Gives a demo the picture of stages 4 and 7: the scene in perspective, and small in a corner the
/// same scene from straight above; `View::from_above` exchanges the two. The ball can be dragged
/// and thrown. `look` is asked for every picture: parameters may have changed.
void use_space_view(Demo& demo, const std::function<BallInSpace(const Simulation&)>& look);

/// The demo of a scene with one ball in space, above a floor or a plane. `look` says what is not in
/// the scene.
template <class Scene, class Phases = NoPhases>
Demo space_demo(const BallInSpace& look = {}) {
  using Its = OneBallRun<Scene, Phases>;
  Demo demo;
  demo.make = [] { return std::make_unique<Its>(); };
  if constexpr (!has_picture) return demo;
  use_space_view(demo, [look](const Simulation& simulation) {
    const Scene scene = run_as<Its>(simulation).scene();
    BallInSpace ball = look;
    ball.radius = scene.radius;
    if constexpr (requires { scene.floor; }) ball.has_plane = scene.floor;
    if constexpr (requires { scene.plane(); }) ball.plane = scene.plane();
    ball.forces = [scene](double t, const State<Eigen::Vector3d>& state) {
      return forces_of(scene, t, state);
    };
    return ball;
  });
  demo.is_over = [](const Playback& playback) {  // without a floor it falls for ever
    if constexpr (requires(const Scene& scene) { scene.floor; }) {
      const bool falls = !run_as<Its>(playback.simulation()).scene().floor;
      return falls && state_in<Eigen::Vector3d>(playback.shown_values()).position.y() < -3;
    }
    return false;
  };
  return demo;
}

}  // namespace bounce
