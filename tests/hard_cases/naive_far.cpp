// Small, deep and far, the naive way.

#include <algorithm>
#include <cmath>

#include "02_spring_floor/spring_floor.hpp"
#include "naive.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::naive {
namespace {

std::string drop_from_a_nanometre() {
  const SpringFloor scene;
  State<double> ball{scene.radius + 1e-9, 0};
  double highest = 0;
  for (int i = 0; i < 100000; ++i) {
    semi_implicit_euler(scene, 0, ball, 1e-3);
    highest = std::max(highest, ball.position - scene.radius);
  }
  return "the slides' loop with steps of 1 ms lifts it to " + digits(highest / 1e-9, 2) +
         " times its height";
}

/// Two equal balls exchange their speeds along the line between them, when they are as near as
/// that.
std::string near_miss_with_a_tolerance() {
  const double tolerance = 1e-6, beside = 0.2 + 1e-9;
  double x = -0.1, vx = 1, vy = 0;
  for (bool hit = false; x < 0.1; x += vx * 1e-6) {
    const double d = std::sqrt(x * x + beside * beside);
    if (hit || !(d < 0.2 + tolerance)) continue;
    hit = true;
    const double approach = -vx * x / d;
    vx += approach * x / d;
    vy += approach * beside / d;
  }
  return "a tolerance of 1e-6 m makes it a hit: the ball is turned aside at " +
         digits(1000 * vy, 2) + " mm/s";
}

std::string pushed_out_at_once() {
  // As games with position correction do it: out of the floor, and the speed is how far that was.
  const double dt = 1e-3, before = 0.05;
  double y = before, v = 0;
  v -= 9.81 * dt;
  y += v * dt;
  if (y < 0.1) y = 0.1;
  v = (y - before) / dt;
  SpringFloor scene;
  State<double> ball{before, 0};
  while (ball.position < scene.radius) rk4(scene, 0, ball, 1e-5);
  return "put back onto the floor in one step of 1 ms, a ball 5 cm deep leaves at " + digits(v, 2) +
         " m/s; the spring gives it " + digits(ball.velocity, 2);
}

std::string centre_below() {
  // The floor is where the centre is not.
  const SpringFloor scene;
  State<double> ball{-0.05, 0};
  for (int i = 0; i < 1000; ++i) {
    const bool touches = std::abs(ball.position) < scene.radius;
    const double push = touches ? scene.stiffness * (scene.radius - std::abs(ball.position)) : 0;
    ball.velocity += ((ball.position < 0 ? -push : push) / scene.mass - scene.gravity) * 1e-3;
    ball.position += ball.velocity * 1e-3;
  }
  return "pushed to the side of its centre, a ball at -5 cm is " + digits(-ball.position, 2) +
         " m below the floor after 1 s";
}

std::string far_in_single_precision() {
  float x = 1e7f;
  for (int i = 0; i < 10000; ++i) x += 1.0f * 1e-3f;
  return "in single precision a ball at 1 m/s has moved by " + digits(double{x} - 1e7) +
         " m after 10 s";
}

std::string time_to_a_denormal_end() {
  int exponent = -300;
  while (std::isfinite(0.9 / std::pow(10, exponent))) --exponent;
  return "the time to the floor, h / v, is infinite from 1e" + std::to_string(exponent) +
         " m/s on, and infinity times v no number";
}

std::string constant_in_metres() {
  const auto hops = [](double speed) {
    int count = 0;
    for (; speed > 0.01; speed *= 0.9) ++count;
    return std::to_string(count);
  };
  return "\"at rest below 0.01\": a ball hops " + hops(4) + " times in metres, and " +
         hops(4 * 1024) + " times in units of 1/1024 m";
}

std::string speed_beyond_reason() {
  const SpringFloor scene;
  State<double> ball{1, -1e308};
  int steps = 0;
  const bool infinite = std::isinf(scene.energy(ball).total());
  for (; std::isfinite(ball.position); ++steps) semi_implicit_euler(scene, 0, ball, 1e-3);
  return std::string("its energy is ") + (infinite ? "infinite" : "finite") +
         " at once, its position after " + std::to_string(steps) + " steps";
}

}  // namespace

void print_far() {
  print_cases({{"A drop from 1e-9 m", drop_from_a_nanometre},
               {"A near miss by 1e-9 m", near_miss_with_a_tolerance},
               {"A start deep in the floor", pushed_out_at_once},
               {"A start with the centre below the floor", centre_below},
               {"Coordinates of 1e7 m", far_in_single_precision},
               {"Denormal velocity", time_to_a_denormal_end},
               {"Units scaled by powers of two", constant_in_metres},
               {"A saved state with a speed of 1e308 m/s", speed_beyond_reason}});
}

}  // namespace bounce::naive
