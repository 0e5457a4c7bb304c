#pragma once
#include <functional>

#include "app/canvas.hpp"
#include "app/demo.hpp"
#include "app/playback.hpp"
#include "physics/forces.hpp"
#include "physics/state.hpp"
#include "run/one_ball_run.hpp"
#include "run/rows.hpp"

namespace bounce {

/// What the side view needs to know of the ball.
struct BallOnALine {
  double radius = 0.1;                                                        // m
  std::function<Forces<double>(double t, const State<double>&)> forces = {};  // N, upwards
  bool floor = true;
  /// Of one that moves [m]; empty: it rests at 0. Its past is drawn from the trace's column
  /// "floor", because its law may have changed since.
  std::function<double(double t)> floor_height = {};
  bool strobe = false;  // leave an image every 0.1 s, beside those of the exact solution
  double lowest = -0.14,
         highest = 1.25;  // in the picture [m]; the top grows when the ball leaves it
};

/// Gives a demo the picture of stages 1 to 3 and 6: ruler, ground, ball and ghost, forces; to the
/// left where the ball has been, to the right (while a slider moves) where it will go: height
/// against time, on the ruler's own scale; so is the path of a floor that moves. With `strobe`, the
/// images stay where they were taken instead. The ball can be dragged and thrown. `look` is asked
/// for every picture: parameters may have changed.
void use_side_view(Demo& demo, const std::function<BallOnALine(const Simulation&)>& look);

/// The demo of a scene with one ball on a line. `look` says what is not in the scene;
/// `Phases` are its closed forms, where there are any.
template <class Scene, class Phases = NoPhases>
Demo side_demo(const BallOnALine& look = {}) {
  using Its = OneBallRun<Scene, Phases>;
  Demo demo;
  demo.make = [] { return std::make_unique<Its>(); };
  if constexpr (!has_picture) return demo;
  use_side_view(demo, [look](const Simulation& simulation) {
    const Scene scene = run_as<Its>(simulation).scene();
    BallOnALine ball = look;
    if constexpr (requires { scene.radius; }) ball.radius = scene.radius;
    if constexpr (requires { scene.floor_height(0.0); }) {
      ball.floor_height = [scene](double t) { return scene.floor_height(t); };
    }
    ball.forces = [scene](double t, const State<double>& state) {
      return forces_of(scene, t, state);
    };
    return ball;
  });
  demo.is_over = [look](const Playback& playback) {  // it fell out of the picture
    return !look.floor && state_in<double>(playback.shown_values()).position < look.lowest;
  };
  return demo;
}

}  // namespace bounce
