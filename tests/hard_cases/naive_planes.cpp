// Floors and planes, the naive way.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "06_oscillating_floor/oscillating_floor.hpp"
#include "naive.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::naive {
namespace {

std::string stroboscope() {
  const double turn = 2 * std::acos(-1.0);
  const double seen = std::remainder(900.0 / 240, turn) * 240;
  return "seen every 1/240 s, 900 rad/s look like " + digits(seen) +
         " rad/s: another floor, backwards";
}

std::string shaken_off() {
  OscillatingFloor scene;
  scene.angular_frequency = 4 * std::acos(-1.0);
  const double most = scene.gravity / std::pow(scene.angular_frequency, 2), dt = 2e-3;
  State<double> ball{scene.radius - scene.mass * scene.gravity / scene.stiffness, 0};
  for (int i = 0;; ++i) {
    scene.amplitude = most * i * dt / 60;
    explicit_euler(scene, i * dt, ball, dt);
    if (ball.position - scene.floor_height((i + 1) * dt) < scene.radius) continue;
    return "shaken more and more, with explicit Euler at 2 ms it is off at $A w^2 = " +
           digits(scene.amplitude / most, 1) + " g$";
  }
}

std::string long_normal() {
  // a x + b y + c z + d with (0, 2, 0).
  double y = 1;
  while (!(2 * y < 0.1)) y -= 1e-4;
  return "with (0, 2, 0) a ball with a radius of 0.1 m touches only at " + digits(y, 2) + " m";
}

std::string no_normal() {
  const Eigen::Vector3d normal(0, 0, 0), n = normal / normal.norm();
  Eigen::Vector3d position(0, 1, 0), velocity(0, 0, 0);
  const double push = 1e4 * std::max(0.0, 0.1 - dot(n, position));
  velocity += push * n * 1e-3;
  position += velocity * 1e-3;
  return "0 / 0: after one step " + std::to_string((position.array() != position.array()).count()) +
         " of 3 coordinates are NaN";
}

std::string flipped_normal() {
  // A ceiling at y = 1, turned upwards because floors are: y - 1 = 0 instead of -y + 1 = 0.
  State<double> ball{0, 0};
  double fastest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double distance = ball.position - 1;
    ball.velocity += (1e4 * std::max(0.0, 0.1 - distance) - 9.81) * 1e-4;
    ball.position += ball.velocity * 1e-4;
    fastest = std::max(fastest, ball.velocity);
  }
  return "turned upwards, a ceiling 1 m above the ball pulls it up through itself, at " +
         digits(fastest, 2) + " m/s";
}

}  // namespace

void print_planes() {
  print_cases({{"A floor faster than the step can see: 900 rad/s at dt = 1/240", stroboscope},
               {"Resting on a shaken floor", shaken_off},
               {"A normal of any length", long_normal},
               {"A normal of length 0", no_normal},
               {"A flipped normal", flipped_normal}});
}

}  // namespace bounce::naive
