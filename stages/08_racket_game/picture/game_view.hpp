#pragma once
#include <memory>
#include <optional>
#include <span>

#include "08_racket_game/picture/loss_again.hpp"
#include "app/demo.hpp"

namespace bounce {

/// The picture of ball and racket. It remembers where the camera is, which follows calmly.
class GameView {
 public:
  void draw(Canvas& canvas, const Playback& playback, const View& view);

  /// The point at the height of the racket's home that is seen at `pixel`.
  std::optional<Eigen::Vector3d> on_racket_plane(Point pixel) const;

  bool is_live = false;  // somebody is playing: say when time stands still

 private:
  Camera camera_for(const Court& court, double t);
  void draw_scene(Canvas& canvas, const Court& court, double t, std::span<const TrailPoint> trail,
                  const View& view);
  void draw_court(Canvas& canvas, const Playback& playback, const View& view);

  Rect area_{0, 0, 1280, 720};
  Eigen::Vector3d focus_{0, 0, 0};  // what the camera looks at, before it is raised
  double home_height_ = 0;
  double last_t_ = -1;
  LossAgain again_;
};

/// Gives the demo this picture.
std::shared_ptr<GameView> use_game_view(Demo& demo);

}  // namespace bounce
