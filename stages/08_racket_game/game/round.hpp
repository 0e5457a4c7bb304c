#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "08_racket_game/game/game.hpp"
#include "08_racket_game/game/input_log.hpp"
#include "08_racket_game/game/players.hpp"
#include "08_racket_game/run/racket_setup.hpp"
#include "physics/contact.hpp"

namespace bounce {

/// What a round is played with: as set up (racket_setup.hpp), and by whom.
struct Settings : RacketSetup {
  PlayerKind player = PlayerKind::human;
  std::uint64_t seed = 1;
};

/// One round of the game, from the serve to the loss: all that the next step depends on.
struct Round {
  State<Eigen::Vector3d> ball{{0, 1, 0}, {0, 0, 0}};
  int side = 1;  // these two as in Racket
  bool through = false;
  Grip grip;
  Score score;
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
      for (auto* number :
           {&input->x, &input->z, &input->tilt_x, &input->tilt_z, &input->swing, &input->assist}) {
        visit("input", *number);
      }
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

/// Where the blind player's racket and ball are at the start: the ball at the top of its flight.
struct BlindStart {
  BlindSwing swing;
  double phase;  // of the racket's sine
  double top;    // of the ball's underside above the middle of the sine [m]
};

inline BlindStart blind_start(const Settings& settings) {
  const SpringDamper law{settings.racket.stiffness, settings.racket.damping,
                         settings.racket.contact};
  const double contact = std::min(contact_time(law, settings.racket.mass), 0.2);
  const double g = settings.racket.gravity;
  BlindStart start;
  const double v = start.swing.speed(g, contact);
  const double hit =
      start.swing.hit_phase(v, settings.restitution(), settings.strike == Settings::slowing);
  const double touch = hit - start.swing.angular_frequency() * contact / 2;
  start.phase = touch - (g > 0 ? start.swing.angular_frequency() * v / g : 0);
  start.top = start.swing.height(0, touch) + (g > 0 ? v * v / (2 * g) : 0);
  return start;
}

inline double gravity_of(const Settings& settings, const Round& round) {
  const double full = settings.racket.gravity;
  return settings.player == PlayerKind::blind ? full : gravity_after(round.score.hits, full);
}
inline double disc_radius_of(const Settings& settings, const Round& round) {
  const double first = settings.racket.disc.radius;
  return settings.player == PlayerKind::blind ? first : disc_radius_after(round.score.hits, first);
}

inline Sight sight_of(const Settings& settings, const Round& round) {
  return {round.ball, settings.racket.radius, gravity_of(settings, round), settings.restitution(),
          settings.racket.disc.centre};
}

/// The serve: up, and a little aside. The best score stays.
inline Round begin_round(const Settings& settings, int number, int best) {
  Round round;
  round.number = number;
  round.score.best = best;
  round.ball = settings.start;
  const Eigen::Vector3d home = settings.racket.disc.centre;
  round.from.x = round.to.x = home.x();
  round.from.z = round.to.z = home.z();
  if (settings.player == PlayerKind::blind) {
    round.ball.position = home;
    round.ball.position.y() += settings.racket.radius + blind_start(settings).top + settings.knock;
    round.ball.velocity.setZero();
  } else {
    round.ball.velocity += Eigen::Vector3d(0, 1.2, 0);
    round.ball.velocity += push(0.13, 0.25, settings.seed, static_cast<std::uint64_t>(number), 0);
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

/// The racket during the next `dt` seconds: where it begins, and the velocities that bring it to
/// where it ends. The grip moves on.
inline Disc move_racket(const Settings& settings, Round& round, double dt) {
  const Eigen::Vector3d home = settings.racket.disc.centre;
  if (settings.player == PlayerKind::blind) {
    const auto [swing, phase, top] = blind_start(settings);
    const double before = swing.height(round.clock, phase);
    round.grip.y.position = swing.height(round.clock + dt, phase);
    round.grip.y.velocity = (round.grip.y.position - before) / dt;
    Disc disc = disc_of(settings, round);
    disc.centre = home + Eigen::Vector3d(0, before, 0);
    disc.velocity = {0, round.grip.y.velocity, 0};
    return disc;
  }
  // Between two inputs the aim moves evenly: a hand does, and its samples do not.
  const double share = std::min(1.0, (round.input_age + dt) / rules::input_time);
  Input now = round.to;
  now.x = round.from.x + share * (round.to.x - round.from.x);
  now.z = round.from.z + share * (round.to.z - round.from.z);
  now = assisted(now, sight_of(settings, round));
  return follow(round.grip, now, home, disc_radius_of(settings, round),
                swing_speed(gravity_of(settings, round)), dt);
}

/// From now on the player wants this.
inline void take_input(Round& round, const Input& input) {
  const double share = std::min(1.0, round.input_age / rules::input_time);
  round.from.x += share * (round.to.x - round.from.x);
  round.from.z += share * (round.to.z - round.from.z);
  round.to = input;
  round.input_age = 0;
}

/// One step of the game. `move_ball(scene, ball, dt)` is the physics: it moves the ball beside the
/// racket of `scene`, and says how often the two touched.
template <class MoveBall>
void step(const Settings& settings, Round& round, double dt, const MoveBall& move_ball) {
  const Disc disc = move_racket(settings, round, dt);
  ++round.steps;
  round.clock += dt;
  round.input_age += dt;
  if (round.score.lost) return;

  Racket scene = settings.racket;
  scene.gravity = gravity_of(settings, round);
  scene.disc = disc;
  scene.since = 0;
  scene.side = round.side;
  scene.through = round.through;
  const Eigen::Vector3d before = round.ball.velocity - scene.disc.velocity;
  const long long touches = move_ball(scene, round.ball, dt);
  round.side = scene.side;
  round.through = scene.through;

  const NearestPoint nearest = scene.nearest(scene.disc_at(dt), round.ball.position);
  if (touches > 0) {
    round.touches += touches;
    round.touch_speed = std::abs(dot(nearest.direction, before));
    round.touch_clock = round.clock;
    round.touch_place = nearest.point;
  }
  const Eigen::Vector3d home = settings.racket.disc.centre;
  const double above_racket =
      round.ball.position.y() - home.y() - round.grip.y.position - scene.radius;
  const double above_floor =
      round.ball.position.y() - scene.radius - (home.y() - rules::floor_below);
  const bool touching = touches > 0 || nearest.distance < scene.radius;
  const bool hit = round.score.watch(touching, above_racket, above_floor);
  if (round.score.lost) round.lost_clock = round.clock;
  if (hit && settings.player != PlayerKind::blind) {
    round.ball.velocity += push(0, 0.12, settings.seed, static_cast<std::uint64_t>(round.number),
                                static_cast<std::uint64_t>(round.score.hits));
  }
}

}  // namespace bounce
