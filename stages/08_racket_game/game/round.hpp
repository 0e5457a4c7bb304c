#pragma once
#include <cstdint>

#include "08_racket_game/game/game.hpp"
#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/game/players.hpp"
#include "08_racket_game/game/points.hpp"
#include "08_racket_game/run/racket_setup.hpp"

namespace bounce {

/// What a round is played with: as set up (racket_setup.hpp), and by whom.
struct Settings : RacketSetup {
  PlayerKind player = PlayerKind::human;
  std::uint64_t seed = 1;

  bool on_beat() const { return mode == blind && player != PlayerKind::blind; }
  /// What machines do in the first mode is counted in hits only.
  bool counts_points() const { return player == PlayerKind::human || mode != keep_up; }
};

/// One round of the game, from the serve to the loss: all that the next step depends on.
struct Round {
  State<Eigen::Vector3d> ball{{0, 1, 0}, {0, 0, 0}};
  int side = 1;  // these two as in Racket
  bool through = false;
  Grip grip;
  Score score;
  Points points;
  Input from, to;        // the racket's aim goes evenly from one to the other,
  double input_age = 0;  // and this is how long ago the other came [s]
  long long steps = 0;
  double clock = 0;       // s
  int number = 0;         // of the round, from 0
  double lost_clock = 0;  // when it was lost [s]

  // The last touch, for picture and sound
  long long touches = 0;
  double touch_speed = 0;     // m/s
  double touch_clock = -1e9;  // s
  Eigen::Vector3d touch_place{0, 0, 0};

  /// As in remembered.hpp.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    constexpr long long most = 1'000'000'000'000'000'000, many = 2'000'000'000;
    visit("ball", self.ball);
    for (auto* follower :
         {&self.grip.x, &self.grip.y, &self.grip.z, &self.grip.lean_x, &self.grip.lean_z}) {
      visit("grip", follower->position);
      visit("grip", follower->velocity);
    }
    for (auto* input : {&self.from, &self.to}) {
      for (auto* number : numbers_of(*input)) visit("input", *number);
    }
    visit("input_age", self.input_age);
    visit("clock", self.clock);
    visit("lost_clock", self.lost_clock);
    visit("touch_speed", self.touch_speed);
    visit("touch_clock", self.touch_clock);
    visit("touch_place", self.touch_place);
    visit.whole("side", self.side, -1, 1);
    visit.whole("through", self.through, 0, 1);
    visit.whole("steps", self.steps, 0, most);
    visit.whole("number", self.number, 0, many);
    visit.whole("touches", self.touches, 0, most);
    visit.whole("hits", self.score.hits, 0, many);
    visit.whole("best", self.score.best, 0, many);
    visit.whole("touched", self.score.touched, 0, 1);
    visit.whole("lost", self.score.lost, 0, 1);
  }
};

inline BlindSwing blind_swing(const Settings& settings) {
  const double contact = settings.hit_time(), g = settings.racket.gravity;
  BlindSwing swing;
  const double w = swing.angular_frequency(), v = swing.speed(g, contact);
  const bool slowing = settings.strike == Settings::slowing;
  swing.phase = swing.hit_phase(v, settings.restitution(), slowing) - w * contact / 2;  // touches
  swing.top = swing.height(0) + (g > 0 ? v * v / (2 * g) : 0);
  swing.phase -= g > 0 ? w * v / g : 0;  // and before that it falls
  return swing;
}

/// When the human plays blind. (The blind player has a swing of its own.)
inline Beat beat_of(const Settings& settings) {
  return beat_for(settings.racket.gravity, settings.restitution(), settings.hit_time());
}

/// Who does not look is spared that it becomes harder.
inline bool is_blind(const Settings& settings) {
  return settings.player == PlayerKind::blind || settings.on_beat();
}
inline double gravity_of(const Settings& settings, const Round& round) {
  const double full = settings.racket.gravity;
  return is_blind(settings) ? full : gravity_after(round.score.hits, full);
}
inline double disc_radius_of(const Settings& settings, const Round& round) {
  const double first = settings.racket.disc.radius;
  return is_blind(settings) ? first : disc_radius_after(round.score.hits, first);
}

/// Where the hit after these shall send the ball.
inline Eigen::Vector3d aim_after(int hits, const Settings& settings, const Round& round) {
  const Eigen::Vector3d home = settings.racket.disc.centre;
  if (settings.mode != Settings::target) return home;
  return home + target_after(hits, settings.seed, round.number);
}

inline PlayerView view_of(const Settings& settings, const Round& round) {
  return {round.ball,
          settings.racket.radius,
          gravity_of(settings, round),
          settings.restitution(),
          settings.racket.disc.centre,
          aim_after(round.score.hits, settings, round)};
}

/// The serve: up, and a little aside. The best scores stay; after a loss it is the next round.
inline Round begin_round(const Settings& settings, const Round& before) {
  Round round;
  round.number = before.number + (before.score.lost ? 1 : 0);
  round.score.best = before.score.best;
  round.points.best = before.points.best;
  round.ball = settings.start;
  const Eigen::Vector3d home = settings.racket.disc.centre;
  round.from.x = round.to.x = home.x();
  round.from.z = round.to.z = home.z();
  if (is_blind(settings)) {
    const double radius = settings.racket.radius;
    round.ball = {home, {0, 0, 0}};
    round.ball.position.y() +=
        settings.on_beat()
            ? radius + rules::stroke / 2 + beat_of(settings).top(settings.racket.gravity)
            : radius + blind_swing(settings).top + settings.knock;
  } else {
    round.ball.velocity += Eigen::Vector3d(0, 1.2, 0);
    round.ball.velocity += push(0.13, 0.25, settings.seed, round.number, 0);
  }
  return round;
}

/// The racket as it is now, at rest in its grip.
inline Disc disc_of(const Settings& settings, const Round& round) {
  Disc disc = settings.racket.disc;
  disc.radius = disc_radius_of(settings, round);
  disc.velocity.setZero();
  disc.normal = round.grip.normal();
  disc.centre += round.grip.shift();
  return disc;
}

/// The law of now, with the ball on its present side of that disc.
inline Racket scene_of(const Settings& settings, const Round& round, const Disc& disc) {
  Racket scene = settings.racket;
  scene.gravity = gravity_of(settings, round);
  scene.disc = disc;
  scene.side = round.side;
  scene.through = round.through;
  return scene;
}

}  // namespace bounce
