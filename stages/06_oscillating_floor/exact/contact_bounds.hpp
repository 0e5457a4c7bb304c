#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "06_oscillating_floor/exact/shaken_contact.hpp"

namespace bounce {

/// What gap and push need to know of the movement in contact.
///
/// The ball's acceleration in contact, a = -g + push / m, is itself a solution of the shaken
/// oscillator: a steady swing with the floor, and a free one f that the damper lets die. The size
/// of a free swing, sqrt(f^2 + (f'/omega0)^2), is like the energy of a spring and never grows, so
/// that both together bound a for ever. Near resonance both are huge and cancel; there a better
/// bound is that the size of a itself grows by no more than the shaking adds, for some time to
/// come. An over-damped contact has no resonance, but two very different rates (free_bounds).
struct ContactNow {
  FloorMovement floor;
  State<double> ball;
  double acceleration, jerk;  // m/s^2, m/s^3
  std::array<double, 4> max;  // bounds of a and its first three derivatives for `window` seconds
  double window;              // s
};

/// The size of its acceleration f = -2 beta v - omega0^2 x [m/s^2].
inline double free_acceleration(const ShakenContact& contact, const State<double>& free) {
  const double omega0 = contact.omega0, beta = contact.beta;
  const double f = -2 * beta * free.velocity - omega0 * omega0 * free.position;
  const double f_rate = -2 * beta * f - omega0 * omega0 * free.velocity;
  return std::sqrt(f * f + f_rate * f_rate / (omega0 * omega0));
}

/// Bounds of a free swing's acceleration f of that size, and of its first three derivatives: they
/// follow from f'' = -2 beta f' - omega0^2 f.
inline std::array<double, 4> swing_bounds(const ShakenContact& contact, double size) {
  const double omega0 = contact.omega0, beta = contact.beta, bend = omega0 * (2 * beta + omega0);
  return {size, omega0 * size, bend * size, (2 * beta * bend + omega0 * omega0 * omega0) * size};
}

/// Bounds of that acceleration from now on, and of the first three derivatives of that. An
/// over-damped swing is a sum of two exponentials, x = p e^(-slow t) + q e^(-fast t), and their
/// rates can be millions apart: once the fast one has died, nothing bends fast any more. Its share
/// now is what it was `before`, `since` seconds ago, less its decay; from the swing as it is now it
/// could not be told, because the rounding of a height, times fast^2, is no small acceleration.
inline std::array<double, 4> free_bounds(const ShakenContact& contact, const State<double>& free,
                                         const State<double>& before, double since) {
  const double omega0 = contact.omega0, beta = contact.beta;
  std::array<double, 4> bounds = swing_bounds(contact, free_acceleration(contact, free));
  if (beta <= omega0) return bounds;
  const double root = std::sqrt((beta - omega0) * (beta + omega0));
  const double fast = beta + root, slow = omega0 * omega0 / fast;
  const double x = before.position, v = before.velocity;
  double p = std::abs(v + fast * x) / (2 * root) * slow * slow * std::exp(-slow * since);
  double q = std::abs(v + slow * x) / (2 * root) * fast * fast * std::exp(-fast * since);
  for (double& bound : bounds) {
    bound = std::min(bound, p + q);
    p *= slow;
    q *= fast;
  }
  return bounds;
}

/// With the ball as it is at `t`, and bounds for at least `window` seconds.
inline ContactNow contact_at(const ShakenContact& contact, double t, const State<double>& ball,
                             Complex turned, double window, const State<double>& free_before,
                             double since) {
  const double omega0 = contact.omega0, beta = contact.beta, w = contact.w;
  ContactNow now;
  now.floor = contact.floor.at(t, turned);
  now.ball = ball;
  now.acceleration = contact.acceleration(now.floor, ball);
  now.jerk = contact.jerk(now.floor, ball, now.acceleration);
  const double shaking = w * w * contact.shaking_size;
  const double a = now.acceleration, b = now.jerk / omega0;
  const double grown = std::sqrt(a * a + b * b) + shaking * window / omega0;

  const double steady = w * w * contact.steady_size;
  const std::array<double, 4> free =
      free_bounds(contact, contact.free_part(ball, t, turned), free_before, since);
  if (beta > omega0 || steady + free[0] < grown) {
    now.window = never;
    double rate = 1;  // each derivative of a swing is w times as large as that before
    for (std::size_t i = 0; i < 4; ++i, rate *= w) now.max[i] = rate * steady + free[i];
  } else {  // a'' = shaking - 2 beta a' - omega0^2 a
    now.window = window;
    now.max = swing_bounds(contact, grown);
    now.max[2] += shaking;
    now.max[3] += (w + 2 * beta) * shaking;
  }
  return now;
}

inline ContactNow contact_at(const ShakenContact& contact, const State<double>& start, double t) {
  const Complex turned = contact.floor.turn(t);
  return contact_at(contact, t, contact.ball_at(start, t, turned), turned, 1 / contact.omega0,
                    contact.free_part(start, 0, 1), t);
}

}  // namespace bounce
