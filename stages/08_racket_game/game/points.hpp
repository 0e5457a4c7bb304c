#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "08_racket_game/game/game.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

// What counts in the three modes of the game, as plain functions. Points never help the ball.

namespace rules {
inline constexpr double band_low = 0.8, band_high = 1.2;  // m, of tops that count twice
inline constexpr double target_reach = 0.4;               // m from the middle of the court
inline constexpr double too_low = 0.4;  // m: blind, a top below this one ends the round
}  // namespace rules

/// Keep-up: a hit is a point. A second one is for a flight whose top is in the band: of the ball's
/// underside, above the lowered racket [m].
inline int bonus_for_top(double top) {
  return top >= rules::band_low && top <= rules::band_high ? 1 : 0;
}

/// Target: so far from the middle of the ring the ball will come down [m].
inline int points_for_landing(double distance) {
  return distance <= 0.1 ? 3 : distance <= 0.2 ? 2 : distance <= 0.35 ? 1 : 0;
}

/// Target: where the ball shall come down after the next hit, from the middle of the court [m].
inline Eigen::Vector3d target_after(int hits, std::uint64_t seed, int round) {
  const double angle = std::numbers::pi * chance(seed, round, hits, 2);
  const double share = (1 + chance(seed, round, hits, 3)) / 2;
  const double away = rules::target_reach * std::sqrt(share);  // evenly over the area
  return {away * std::cos(angle), 0, away * std::sin(angle)};
}

/// Blind: when to swing. A racket that meets the ball at every beat, in the middle of its stroke,
/// keeps it at one height: v = e v + (1 + e) u, so that v = u (1 + e) / (1 - e).
struct Beat {
  double speed = 0;   // of the ball, before and after a touch [m/s]
  double first = 0;   // s, when the first swing shall begin
  double period = 0;  // s

  /// How many there have been.
  int count(double t) const {
    return !(period > 0) || t < first ? 0 : 1 + static_cast<int>((t - first) / period);
  }
  /// How far it is from one to the next, from 0 to 1.
  double phase(double t) const {
    const double beats = period > 0 ? (t - first) / period : 0;
    return beats - std::floor(beats);
  }
  /// The ball begins at the top of its flight, so high above where it will be touched [m].
  double top(double gravity) const { return gravity > 0 ? speed * speed / (2 * gravity) : 0; }
};

inline Beat beat_for(double gravity, double restitution, double contact_time) {
  const double swing = swing_speed(gravity), highest = std::sqrt(2 * gravity * 2);  // 2 m
  Beat beat;
  if (!(gravity > 0)) return beat;
  beat.speed =
      restitution < 1 ? std::min(highest, swing * (1 + restitution) / (1 - restitution)) : highest;
  beat.period = 2 * beat.speed / gravity + contact_time;
  const double lead = rules::stroke / 2 / swing + 0.01;  // half the stroke, and to get to speed
  beat.first = beat.speed / gravity - lead;
  return beat;
}

/// The points of a round.
struct Points {
  int total = 0;
  int best = 0;         // of all rounds in this mode, with this assist
  int last = 0;         // the latest that were given, of a hit or of a top,
  double clock = -1e9;  // and when [s]
  bool flies = false;   // a hit was counted, and its top is still to come
  double assist = 0;    // the most help that was taken in this round, from 0 to 1

  void give(int points, double now) {
    if (points == 0) return;
    last = points;
    clock = now;
    total += points;
    best = std::max(best, total);
  }

  /// As in remembered.hpp.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    constexpr long long many = 2'000'000'000;
    visit.whole("points", self.total, 0, many);
    visit.whole("best points", self.best, 0, many);
    visit.whole("last points", self.last, 0, 3);
    visit("points' clock", self.clock);
    visit.whole("flies", self.flies, 0, 1);
    visit("most assist", self.assist);
  }
};

}  // namespace bounce
