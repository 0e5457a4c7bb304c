#pragma once
#include <Eigen/Core>
#include <functional>

#include "app/canvas.hpp"
#include "app/demo.hpp"
#include "app/player.hpp"
#include "physics/shapes.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Forces on a ball in space [N].
struct ForcesInSpace {
  Eigen::Vector3d gravity{0, 0, 0}, spring{0, 0, 0}, damper{0, 0, 0};
};

/// What the view in space needs to know of the ball and the plane it bounces on.
struct BallInSpace {
  double radius = 0.1;  // m
  std::function<ForcesInSpace(const State<Eigen::Vector3d>&)> forces;
  Plane plane;
  bool has_plane = true;
  bool landings = false;  // mark where it touched, with the distances between the marks
  Eigen::Vector3d look_at{1.1, 0.55, 0.4};  // the middle of the picture at first [m]
  double room = 1.3;                        // the camera follows a ball further away than this [m]
  double distance = 4.3;                    // of the camera from what it looks at [m]
};

/// The scene of stages 4 and 7 in perspective, and small in a corner the same scene from straight
/// above; `View::from_above` exchanges the two.
void draw_space_view(Canvas& canvas, const Player& player, const View& view,
                     const BallInSpace& ball);

/// Gives a demo this scene as its picture, with a ball that can be dragged and thrown.
void use_space_view(Demo& demo, std::function<BallInSpace(const Player&)> ball);

}  // namespace bounce
