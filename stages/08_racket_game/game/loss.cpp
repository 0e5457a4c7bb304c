#include "08_racket_game/game/loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double between_moments = 1e-3;  // s, at least
constexpr double at_rest = 0.15;          // s: who touches for so long does not bounce any more
constexpr double around = 0.5;  // s before and after a touch, where its swing is looked for

Vector3d along_ground(const Vector3d& v) { return {v.x(), 0, v.z()}; }

/// The last contact, as indices of moments: it begins in the step that ends with the first one.
struct Contact {
  std::size_t first = 0, last = 0;
};
Contact last_contact(std::span<const Moment> all) {
  Contact contact;
  for (std::size_t i = 1; i < all.size(); ++i) {
    // A stiff one may be over within a step.
    if (all[i].touches == all[i - 1].touches && all[i].push.isZero()) continue;
    // A gap of 20 ms is no flight.
    if (contact.last == 0 || all[i].t - all[contact.last].t > 0.02) contact.first = i;
    contact.last = i;
  }
  return contact;
}

/// When the racket was fast, last before the touch and first after it, not further than `around`.
struct Swing {
  double before = -never, after = never;  // s
};
Swing swing_near(std::span<const Moment> all, double touch, double fast) {
  Swing swing;
  for (const Moment& moment : all) {
    if (std::abs(moment.t - touch) > around || moment.disc.velocity.y() < fast) continue;
    if (moment.t <= touch) swing.before = std::max(swing.before, moment.t);
    if (moment.t > touch) swing.after = std::min(swing.after, moment.t);
  }
  return swing;
}

}  // namespace

Moment moment_of(const GameRun& run) {
  const Round& round = run.round();
  const Grip& grip = round.grip;
  Racket scene = run.scene_now();
  scene.disc.velocity = {grip.x.velocity, grip.y.velocity, grip.z.velocity};
  // A unit vector n that changes by n' turns with n x n'; for small angles n' is this.
  const Vector3d turns(grip.lean_x.velocity, 0, grip.lean_z.velocity);
  scene.disc.angular_velocity = scene.disc.normal.cross(turns);
  const Vector3d weight(0, -scene.mass * scene.gravity, 0);
  return {round.clock,
          round.ball,
          scene.disc,
          scene.force(0, round.ball) - weight,
          scene.nearest(scene.disc, round.ball.position),
          round.touches};
}

std::vector<Moment> watch_again(GameRun run, double until) {
  std::vector<Moment> all{moment_of(run)};
  while (!run.round().score.lost && run.round().clock < until + between_moments) {
    run.advance_one_step();
    if (run.round().clock - all.back().t > 0.9 * between_moments) all.push_back(moment_of(run));
  }
  return all;
}

Moment between(const Moment& a, const Moment& b, double t) {
  Moment mixed = a;
  const double share = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 0;
  const auto mix = [share](Vector3d& from, const Vector3d& to) { from += share * (to - from); };
  mixed.t = t;
  mix(mixed.ball.position, b.ball.position);
  mix(mixed.ball.velocity, b.ball.velocity);
  mix(mixed.disc.centre, b.disc.centre);
  mix(mixed.disc.normal, b.disc.normal);
  mix(mixed.push, b.push);
  mixed.disc.normal.normalize();
  mixed.nearest.distance += share * (b.nearest.distance - a.nearest.distance);
  return mixed;
}

Loss loss_of(std::span<const Moment> all, double swing, double gravity) {
  Loss loss;
  // Where it fell past the disc: the last time that it was level with it.
  for (std::size_t i = all.size(); i-- > 1;) {
    const Moment &now = all[i], &before = all[i - 1];
    const double height = now.ball.position.y() - now.disc.centre.y();
    if (!(height < 0 && before.ball.position.y() >= before.disc.centre.y())) continue;
    loss.missed = along_ground(now.ball.position - now.disc.centre).norm();
    loss.beyond = loss.missed - now.disc.radius;
    loss.flight = now.t;  // for the moment: when
    break;
  }
  const Contact contact = last_contact(all);
  if (contact.last == 0) return loss;

  const Moment &met = all[contact.first], &before = all[contact.first - 1];
  const Moment& left = all[std::min(contact.last + 1, all.size() - 1)];
  loss.flight = std::max(0.0, loss.flight - left.t);
  loss.racket = met.disc.velocity_of(met.nearest.point).y();
  loss.lean = std::acos(std::clamp(met.disc.normal.y(), -1.0, 1.0));
  loss.beside = met.disc.outwards(met.ball.position).norm();
  const Vector3d came = along_ground(before.ball.velocity), went = along_ground(left.ball.velocity);
  loss.sideways = went.norm();
  const double up = std::max(0.0, left.ball.velocity.y());
  loss.rose = gravity > 0 ? up * up / (2 * gravity) : 0;

  const Moment& end = all[contact.last];
  const bool over_rim = end.disc.outwards(end.ball.position).norm() >= end.disc.radius;
  if (end.t - met.t > at_rest && over_rim) {
    loss.cause = Loss::slid_off;
  } else if (over_rim) {
    loss.cause = Loss::rim;
  } else if (went.norm() > came.norm() &&
             (went - came).norm() * loss.flight > met.disc.radius / 2) {
    loss.cause = Loss::tilted;  // by itself this sent the ball half a disc aside
  } else if (loss.racket < -0.05 * swing) {
    loss.cause = Loss::downwards;
  } else if (loss.racket < 0.5 * swing) {
    const Swing near = swing_near(all, met.t, 0.5 * swing);
    const double early = met.t - near.before, late = near.after - met.t;
    loss.off_by = std::min(early, late);
    loss.cause = loss.off_by > around ? Loss::no_swing : early < late ? Loss::early : Loss::late;
  } else {
    loss.cause = Loss::elsewhere;
  }
  return loss;
}

std::string to_sentence(const Loss& loss) {
  const auto text = [](const char* form, double number) {
    std::array<char, 80> words{};
    std::snprintf(words.data(), words.size(), form, number);
    return std::string(words.data());
  };
  const auto cm = [&](double metres) { return text("%.0f cm", 100 * metres); };
  const std::string leaned = text("%.0f degrees", loss.lean / rules::degree);
  std::string past = cm(loss.missed) + " from the disc's centre";
  if (loss.beyond > 0.005) past += ", " + cm(loss.beyond) + " beyond its rim";
  const std::string back =
      loss.missed > 0 ? "The ball was back after " + text("%.1f s, ", loss.flight) + past + "."
                      : "The ball rose only " + cm(loss.rose) + ".";
  switch (loss.cause) {
    case Loss::no_touch:
      return "No touch: the ball came down " + past + ".";
    case Loss::slid_off:
      return "The ball did not bounce any more, and slid over the rim with " +
             text("%.1f m/s.", loss.sideways);
    case Loss::rim:
      return "Hit over the rim, " + cm(loss.beside) + " beside the centre: the ball left to the " +
             text("side with %.1f m/s.", loss.sideways);
    case Loss::tilted:
      return "Hit " + cm(loss.beside) + " beside the centre, tilted by " + leaned +
             text(": the ball left to the side with %.1f m/s. ", loss.sideways) + back;
    case Loss::downwards:
      return text("The racket moved down with %.2f m/s at the touch, ", -loss.racket) +
             "which took speed from the ball. " + back;
    case Loss::early:
      return text("Too early by %.0f ms: the swing was over. ", 1000 * loss.off_by) + back;
    case Loss::late:
      return text("Too late by %.0f ms: the racket did not move up yet. ", 1000 * loss.off_by) +
             back;
    case Loss::no_swing:
      return "No swing: the racket stood still at the touch. " + back;
    case Loss::elsewhere:
      if (loss.missed == 0) return "The swing was right, but the ball came too slowly. " + back;
      return "The hit was good, but the disc was elsewhere. " + back;
  }
  return "";
}

}  // namespace bounce
