// Steps and stiffness, the naive way.

#include <algorithm>
#include <cmath>

#include "02_spring_floor/spring_floor.hpp"
#include "08_racket_game/racket_game.hpp"
#include "naive.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "stability_measured.hpp"

namespace bounce::naive {
namespace {

std::string contact_with_explicit_euler() {
  const SpringFloor scene;  // omega0 = 100 /s
  State<double> ball{scene.radius, -4};
  const double before = scene.energy(ball).total();
  do {
    explicit_euler(scene, 0, ball, 1e-3);
  } while (ball.position < scene.radius);
  return "with explicit Euler at $" + omega0_dt + " = 0.1$ a contact returns " +
         digits(scene.energy(ball).total() / before) + " times the energy";
}

std::string nearly_unstable() {
  const auto [lowest, highest] =
      hard_cases::restitution_range(methods::semi_implicit_euler, {0}, 1.9, 1000);
  return "at $" + omega0_dt + " = 1.9$ an undamped ball comes back with " + digits(lowest, 2) +
         " to " + digits(highest) + " times its speed, as the steps happen to fall";
}

std::string nearly_unstable_and_damped() {
  const double limit = methods::semi_implicit_euler.largest_stable_step(1, 1);
  const auto [lowest, highest] =
      hard_cases::restitution_range(methods::semi_implicit_euler, {1}, 0.99 * limit, 1000);
  return "at critical damping and 99 % of the stable limit a ball that should stay leaves with up "
         "to " +
         digits(highest) + " times its speed";
}

std::string lucky_step() {
  const auto error = [](double step) {
    const auto [lowest, highest] =
        hard_cases::restitution_range(methods::semi_implicit_euler, {0}, step, 1000);
    return digits(std::max(1 - lowest, highest - 1), 1);
  };
  return "a test at $" + omega0_dt + " = 1$ alone finds a restitution wrong by " + error(1) +
         "; at 1.1 it is wrong by " + error(1.1);
}

std::string stiff_contact() {
  SpringFloor scene;
  scene.mass = 0.021;
  scene.stiffness = 3.1e6;
  State<double> ball = scene.start;
  const double before = scene.energy(ball).total();
  for (int i = 0; i < 2000; ++i) semi_implicit_euler(scene, 0, ball, 1e-3);
  return "with steps of 1 ms the ball has " + digits(scene.energy(ball).total() / before) +
         " times its energy after 2 s";
}

std::string dust_grain() {
  SpringFloor scene;
  scene.mass = 1e-12;
  scene.stiffness = 1e9;
  State<double> ball = scene.start;
  while (!(ball.velocity > 0)) semi_implicit_euler(scene, 0, ball, 1e-3);
  return "a step of 1 ms throws it back at " + digits(ball.velocity, 1) + " m/s, " +
         digits(ball.velocity / 299792458, 1) + " times the speed of light";
}

std::string steps_that_lead_nowhere() {
  const auto after_a_million = [](double dt) {
    double t = 0;
    for (int i = 0; t < 1 && i < 1000000; ++i) t += dt;
    return digits(t, 1);
  };
  return "`while (t < 1) t += dt` has no end: a million steps of 0, -1e-3 and 1e-320 s lead to " +
         after_a_million(0) + ", " + after_a_million(-1e-3) + " and " + after_a_million(1e-320) +
         " s";
}

std::string step_that_does_not_divide() {
  const SpringFloor scene;
  State<double> ball{100, 0};
  double t = 0;
  for (; t < 1; t += 0.3) rk4(scene, t, ball, 0.3);
  return "`while (t < 1) t += 0.3` ends at " + digits(t) + " s, with the ball " +
         digits(100 - 9.81 / 2 - ball.position) + " m too low";
}

std::string step_of_a_stall() {
  const SpringFloor scene;
  State<double> ball = scene.start;
  semi_implicit_euler(scene, 0, ball, 30);
  return "one step of 30 s: the ball is " + digits(-ball.position / 1000, 2) +
         " km below the floor";
}

std::string step_of_a_stall_in_the_racket() {
  const Racket scene;
  State<Eigen::Vector3d> ball{{0, 0.08, 0}, {0, -1, 0}};  // 2 cm deep
  semi_implicit_euler(scene, 0, ball, 30);
  return "one step of 30 s: the ball is " + digits(ball.position.y() / 1000, 2) +
         " km above the racket";
}

/// x = c1 exp(s1 t) + c2 exp(s2 t), as it stands in the textbook for an over-damped oscillator.
double over_damped(double x0, double v0, double w, double beta, double t) {
  const double gamma = std::sqrt(beta * beta - w * w), s1 = -beta + gamma, s2 = -beta - gamma;
  return ((v0 - s2 * x0) * std::exp(s1 * t) - (v0 - s1 * x0) * std::exp(s2 * t)) / (s1 - s2);
}

std::string critical_damping() {
  const double w = 100, x0 = 1e-3, v0 = -3, t = 0.01;
  const double right = (x0 + (v0 + w * x0) * t) * std::exp(-w * t);
  const double error = std::abs(over_damped(x0, v0, w, w * (1 + 1e-15), t) / right - 1);
  const bool none = std::isnan(over_damped(x0, v0, w, w, t));
  return "the textbook's two exponentials lose " + digits(16 + std::log10(error), 1) +
         " of 16 digits within 1e-15 of critical, and give " + (none ? "no number" : "a number") +
         " at critical";
}

std::string steps_of_a_frame() {
  int steps = 0;
  for (double t = 0; t < 1.0 / 60; t += 1e-7) ++steps;
  return "at dt = 1e-7 s a frame of 1/60 s has " + std::to_string(steps) +
         " steps, and the picture waits for all of them";
}

}  // namespace

void print_steps() {
  print_cases({{"A ball bounces higher each time", contact_with_explicit_euler},
               {"Stable, and wrong", nearly_unstable},
               {"The same with a damper", nearly_unstable_and_damped},
               {"One lucky step", lucky_step},
               {"A stiff contact: m = 0.021 kg, k = 3.1e6 N/m", stiff_contact},
               {"A dust grain of 1e-12 kg, k = 1e9 N/m", dust_grain},
               {"dt = 0, negative or denormal", steps_that_lead_nowhere},
               {"dt divides neither frame nor duration", step_that_does_not_divide},
               {"A stall of 30 s", step_of_a_stall},
               {"The same in the game, with the ball in the racket", step_of_a_stall_in_the_racket},
               {"More steps than a frame has time for", steps_of_a_frame},
               {"Over-damped, critical, within 1e-9 of critical", critical_damping}});
}

}  // namespace bounce::naive
