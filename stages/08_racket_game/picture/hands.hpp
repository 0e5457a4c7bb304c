#pragma once
#include <algorithm>
#include <memory>

#include "08_racket_game/game/game_run.hpp"
#include "08_racket_game/picture/game_view.hpp"
#include "app/demo.hpp"
#include "app/kept_number.hpp"

namespace bounce {

/// From keys and mouse to what the racket shall do. The mouse moves it, or the arrow keys,
/// whichever was used last.
class Hands {
 public:
  void operator()(Playback& playback, const Controls& controls, const GameView& view) {
    GameRun& run = run_as<GameRun>(playback.simulation());
    keep_best(run);
    if (controls.less) run.set_assist(run.settings().assist - 10);
    if (controls.more) run.set_assist(run.settings().assist + 10);

    const Round& round = run.round();
    // Not at once: that key was meant for the ball.
    if (round.score.lost && controls.any && round.clock - round.lost_clock > 0.5) {
      playback.restart();
      return;
    }
    if (!run.is_recorded() && !run.is_replay()) {
      run.record(std::make_shared<InputLog>());  // to see a loss again
    }

    const Eigen::Vector3d home = run.settings().racket.disc.centre;
    if (controls.mouse_moved) {
      if (const auto place = view.on_racket_plane(controls.mouse)) {
        aim_.x = place->x() - home.x();
        aim_.z = place->z() - home.z();
      }
    }
    const double reach = walking_speed * std::min(controls.seconds, 0.1);
    aim_.x += reach * (controls.right - controls.left);
    aim_.z += reach * (controls.down - controls.up);
    aim_.x = std::clamp(aim_.x, -court, court);
    aim_.z = std::clamp(aim_.z, -court, court);

    Input input;
    input.x = home.x() + aim_.x;
    input.z = home.z() + aim_.z;
    input.tilt_x = controls.d - controls.a;
    input.tilt_z = controls.s - controls.w;
    input.swing = controls.space || controls.button ? 1 : 0;
    run.want(input);
  }

 private:
  static constexpr double court = 1.2;          // m from the middle to each side
  static constexpr double walking_speed = 1.5;  // m/s, with the arrow keys

  void keep_best(GameRun& run) {
    if (run.settings().player != PlayerKind::human || run.is_replay()) return;
    if (best_ < 0) run.keep_best(best_ = kept_number(best_score));
    if (run.round().score.best > best_) keep_number(best_score, best_ = run.round().score.best);
  }

  struct Aim {
    double x = 0, z = 0;
  } aim_;
  static constexpr const char* best_score = "racket_game_best";
  int best_ = -1;  // not read yet
};

/// Gives the demo to a player's hands.
inline void use_hands(Demo& demo, const std::shared_ptr<GameView>& view) {
  demo.control = [hands = std::make_shared<Hands>(), view](Playback& playback, const View&,
                                                           const Controls& controls) {
    view->is_live = true;
    if (run_if<GameRun>(playback.simulation())) (*hands)(playback, controls, *view);
  };
}

}  // namespace bounce
