#include "05_ball_collision/picture/balls_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/layout.hpp"

namespace bounce {

using Eigen::Vector3d;

Framing framing_of(const BallsRun& balls) {
  if (balls.world().own_balls) {
    const Arrangement& start = *balls.world().own_balls;
    const Vector3d low = start.balls.position.rowwise().minCoeff();
    const Vector3d high = start.balls.position.rowwise().maxCoeff();
    return {(low + high) / 2, 2 * (high - low).norm() + 6 * start.radius.maxCoeff()};
  }
  const double width = std::max(balls.scene().tray[0], balls.scene().tray[1]);
  switch (balls.world().choice.scene) {
    case BallScene::pair:
      return {{0, 0.1, 0}, 1.6};
    case BallScene::break_up:
      return {{0.4, 0, 0}, 3.0, 1.1};
    case BallScene::cradle:
      return {{0, 0.1, 0}, 1.5};
    case BallScene::tower:
      return {{0, 3.3, 0}, 7.6, 0.12};
    case BallScene::drop:
      break;
  }
  if (width == 0) {
    const double count = static_cast<double>(balls.balls());
    return {{0.1 * std::sqrt(count) / 2, 0.3, 0.1 * std::sqrt(count) / 2}, 0.3 * std::sqrt(count)};
  }
  return {{balls.scene().tray[0] / 2, 0.35 * width, balls.scene().tray[1] / 2}, 1.65 * width, 0.45};
}

Camera camera_for(const Playback& playback, const View& view) {
  const Framing framing = framing_of(balls_of(playback));
  const double distance = framing.size / 2 / std::tan(usual_opening * std::numbers::pi / 360);
  return camera_before(framing.centre, distance, framing.steepness, layout::scene, view.from_above);
}

}  // namespace bounce
