#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

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
    if (controls.next && !run.is_replay()) {
      run.use_next_mode();
      playback.restart();
    }
    keep_best(run);
    if (controls.less) run.set_assist(run.settings().assist - 10);
    if (controls.more) run.set_assist(run.settings().assist + 10);

    const Round& round = run.round();
    // Not at once: that key was meant for the ball.
    if (round.score.lost && controls.any && round.clock - round.lost_clock > 0.5) {
      playback.restart();
      return;
    }
    const bool human = run.settings().player == PlayerKind::human;
    if (human && !run.is_recorded() && !run.is_replay()) {
      run.record(std::make_shared<InputLog>());  // to see a loss again
    }

    const Eigen::Vector3d home = run.settings().racket.disc.centre;
    if (controls.mouse_moved) {
      if (const auto place = view.on_racket_plane(controls.mouse)) {
        aim_ = *place - home;
      }
    }
    const double reach = walking_speed * std::min(controls.seconds, 0.1);
    aim_.x() += reach * (controls.right - controls.left + controls.move_x);
    aim_.z() += reach * (controls.down - controls.up + controls.move_z);
    aim_ = aim_.cwiseMax(-rules::court).cwiseMin(rules::court);

    run.want({.x = home.x() + aim_.x(),
              .z = home.z() + aim_.z(),
              .tilt_x = controls.d - controls.a + controls.tilt_x,
              .tilt_z = controls.s - controls.w + controls.tilt_z,
              .swing = controls.swings() ? 1.0 : 0.0});
  }

 private:
  static constexpr double walking_speed = 1.5;  // m/s, with the arrow keys

  /// One for each mode, and for the most help that was taken in the round.
  void keep_best(GameRun& run) {
    if (run.settings().player != PlayerKind::human || run.is_replay()) return;
    const double assist = std::max(run.settings().assist, 100 * run.round().points.assist);
    const std::string name = "racket_game_" + mode_names[run.settings().mode] + "_" +
                             std::to_string(std::lround(assist));
    if (name != best_name_) {
      best_name_ = name;
      run.use_best(best_ = kept_number(name));
    }
    if (run.round().points.best > best_) keep_number(name, best_ = run.round().points.best);
  }

  Eigen::Vector3d aim_{0, 0, 0};  // from home; its height does not count
  std::string best_name_;
  int best_ = 0;
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
