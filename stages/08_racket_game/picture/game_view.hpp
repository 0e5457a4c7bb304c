#pragma once
#include <Eigen/Core>
#include <optional>

#include "08_racket_game/run/racket_run.hpp"
#include "app/camera.hpp"
#include "app/demo.hpp"

namespace bounce {

/// The picture of ball and racket. It remembers where the camera is, which follows calmly.
class GameView {
 public:
  void draw(Canvas& canvas, const Player& player, const View& view, bool bare);

  /// The point at the height of the racket's home that is seen at `pixel`.
  std::optional<Eigen::Vector3d> on_racket_plane(Point pixel) const;

  bool is_live = false;  // somebody is playing: say when time stands still

 private:
  Camera camera_for(const RacketRun& run, double t);
  void draw_scene(Canvas& canvas, const Player& player, const View& view);

  Rect area_{0, 0, 1280, 720};
  Eigen::Vector3d focus_{0, 0, 0};  // what the camera looks at, before it is raised
  double home_height_ = 0;
  double last_t_ = -1;
};

}  // namespace bounce
