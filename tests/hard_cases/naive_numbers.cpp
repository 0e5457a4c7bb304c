// What goes wrong naively, measured: each function does it the naive way, and says how wrong it is.
// Prints the table of docs/hard_cases.md.

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "02_spring_floor/spring_floor.hpp"
#include "03_damping/damping.hpp"
#include "05_ball_collision/ball_collision.hpp"
#include "08_racket_game/racket.hpp"
#include "physics/integrators.hpp"
#include "physics/text.hpp"

using namespace bounce;

namespace {

std::string digits(double value, int count = 3) { return to_rounded_text(value, count); }

// ---- Steps and stiffness

std::string contact_with_explicit_euler() {
  const SpringFloor scene;  // omega0 = 100 /s
  State<double> ball{scene.radius, -4};
  const double before = scene.energy(ball).total();
  do {
    explicit_euler(scene, 0, ball, 1e-3);
  } while (ball.position < scene.radius);
  return digits(scene.energy(ball).total() / before) + " times the energy after one contact";
}

std::string stiff_contact() {
  SpringFloor scene;
  scene.mass = 0.021;
  scene.stiffness = 3.1e6;
  State<double> ball = scene.start;
  const double before = scene.energy(ball).total();
  for (int i = 0; i < 2000; ++i) semi_implicit_euler(scene, 0, ball, 1e-3);
  return digits(scene.energy(ball).total() / before) + " times the energy after 2 s";
}

std::string step_of_a_stall() {
  const SpringFloor scene;
  State<double> ball = scene.start;
  semi_implicit_euler(scene, 0, ball, 30);
  return "the ball is at " + digits(ball.position, 4) + " m after it";
}

std::string step_that_does_not_divide() {
  const SpringFloor scene;
  State<double> ball{100, 0};
  double t = 0;
  for (; t < 1; t += 0.3) rk4(scene, t, ball, 0.3);
  return "asked for 1 s, the run ends at " + digits(t) + " s, and the ball is " +
         digits(100 - 9.81 / 2 - ball.position) + " m too low";
}

/// x = c1 exp(s1 t) + c2 exp(s2 t), as it stands in the textbook for an over-damped oscillator.
double over_damped(double x0, double v0, double w, double beta, double t) {
  const double gamma = std::sqrt(beta * beta - w * w), s1 = -beta + gamma, s2 = -beta - gamma;
  return ((v0 - s2 * x0) * std::exp(s1 * t) - (v0 - s1 * x0) * std::exp(s2 * t)) / (s1 - s2);
}

std::string critical_damping() {
  const double w = 100, x0 = 1e-3, v0 = -3, t = 0.01;
  const double right = (x0 + (v0 + w * x0) * t) * std::exp(-w * t);
  const auto error = [&](double delta) {
    return std::abs(over_damped(x0, v0, w, w * (1 + delta), t) / right - 1);
  };
  const bool none = std::isnan(over_damped(x0, v0, w, w, t));
  return "wrong by " + digits(error(1e-15), 1) + " of it within 1e-15 of critical, " +
         (none ? "no number" : "a number") + " at critical";
}

// ---- Long, small and far

std::string time_added_up() {
  double t = 0;
  for (int i = 0; i < 10000000; ++i) t += 0.1;
  const double late = t - 1e6;
  return "after 1e7 steps of 0.1 s the clock is " + digits(std::abs(late), 2) +
         " s off, a swing of 100 rad/s " + digits(std::abs(late) * 100, 2) + " rad";
}

std::string angle_of_a_late_time() {
  const double w = 62.83, t = 1e6;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double now = t + i * 0.0137;
    const long double right = static_cast<long double>(w) * static_cast<long double>(now);
    worst =
        std::max(worst, static_cast<double>(std::abs(right - static_cast<long double>(w * now))));
  }
  return "the angle is rounded by up to " + digits(worst, 2) + " rad";
}

std::string drop_from_a_nanometre() {
  const SpringFloor scene;
  State<double> ball{scene.radius + 1e-9, 0};
  double highest = 0;
  for (int i = 0; i < 100000; ++i) {
    semi_implicit_euler(scene, 0, ball, 1e-3);
    highest = std::max(highest, ball.position - scene.radius);
  }
  return "steps of 1 ms lift it to " + digits(highest / 1e-9, 2) + " times its height";
}

std::string hops_of_a_hard_floor() {
  double t = 0, v = 4, hops = 0;
  for (double before = -1; t > before; ++hops) {
    before = t;
    t += 2 * v / 9.81;
    v *= 0.9;
  }
  return digits(hops, 4) + " hops at a restitution of 0.9, until they no longer advance a double";
}

std::string far_in_single_precision() {
  float x = 1e7f;
  for (int i = 0; i < 10000; ++i) x += 1.0f * 1e-3f;
  return "in single precision a ball at 1 m/s has moved by " + digits(double{x} - 1e7) +
         " m after 10 s";
}

std::string back_with_explicit_euler() {
  SpringFloor scene;
  State<double> ball = scene.start;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  ball.velocity = -ball.velocity;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  return "explicit Euler, 3 s and back, misses the start by " +
         digits(std::abs(ball.position - scene.start.position), 2) + " m";
}

// ---- Floors, planes and rackets

std::string thin_disc() {
  int through = 0;
  for (int i = 0; i < 1000; ++i) {
    Racket scene;
    scene.gravity = 0;
    scene.damping = 0;
    scene.stiffness = 1e8;
    scene.disc.radius = 1;
    State<Eigen::Vector3d> ball{{0.1, 1 + i * 0.004, 0}, {0, -400, 0}};
    for (int step = 0; step < 10; ++step) {
      scene.side = ball.position.y() < 0 ? -1 : 1;
      semi_implicit_euler(scene, 0, ball, 0.01);
    }
    through += ball.velocity.y() == -400 ? 1 : 0;
  }
  return std::to_string(through) + " of 1000 balls pass it without a touch";
}

std::string stroboscope() {
  const double turn = 2 * std::acos(-1.0);
  const double seen = std::remainder(900.0 / 240, turn) * 240;
  return "looks like " + digits(seen) + " rad/s";
}

std::string long_normal() {
  // a x + b y + c z + d with (0, 2, 0): the distance of a ball at y = 0.05.
  return "with (0, 2, 0), the distance of a point at 0.05 m is " + digits(2 * 0.05) + " m";
}

// ---- Balls among each other

std::string coincident_centres() {
  const Eigen::Vector3d between(0, 0, 0);
  const Eigen::Vector3d e12 = between / between.norm();
  return std::string("its direction is ") + (e12.allFinite() ? "a vector" : "no number");
}

std::string step_of_the_heavy_one() {
  BallCollision scene;
  scene.gravity = 0;
  scene.floor = false;
  scene.mass.resize(2);
  scene.mass << 1, 1e-6;
  scene.radius = Eigen::VectorXd::Constant(2, 0.1);
  State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 2)};
  balls.position(0, 0) = -0.21;
  balls.velocity(0, 0) = 1;
  for (int i = 0; i < 100; ++i) semi_implicit_euler(scene, 0, balls, 1e-3);  // omega0 dt = 0.1
  return "the light one leaves at " + digits(balls.velocity.col(1).norm(), 2) +
         " m/s, and should at 2";
}

std::string pair_by_pair() {
  // Three equal balls touch in a row; the first one comes at 1 m/s. Each pair trades its speeds.
  const auto last_speed = [](bool from_the_left) {
    double v[3] = {1, 0, 0};
    for (const int i : {from_the_left ? 0 : 1, from_the_left ? 1 : 0}) std::swap(v[i], v[i + 1]);
    return v[2];
  };
  return "the last of three leaves at " + digits(last_speed(true)) + " or at " +
         digits(last_speed(false)) + " m/s, as the pairs are ordered";
}

struct Row {
  const char* name;
  const char* way;
  std::string (*measure)();
};

constexpr Row rows[] = {
    {"A ball bounces higher each time", "explicit Euler, omega0 dt = 0.1",
     contact_with_explicit_euler},
    {"A stiff contact", "m = 0.021 kg, k = 3.1e6 N/m, steps of 1 ms", stiff_contact},
    {"A stall of 30 s", "one step of 30 s", step_of_a_stall},
    {"dt does not divide the duration", "while (t < 1) t += 0.3", step_that_does_not_divide},
    {"Critical damping", "two exponentials", critical_damping},
    {"1e6 s", "t += dt", time_added_up},
    {"sin(w t) at t = 1e6 s", "w times t in a double", angle_of_a_late_time},
    {"A drop from 1e-9 m", "the slides' loop", drop_from_a_nanometre},
    {"Bounces to rest", "a hard floor", hops_of_a_hard_floor},
    {"Coordinates of 1e7 m", "x += v dt", far_in_single_precision},
    {"Time reversal", "undamped", back_with_explicit_euler},
    {"A thin disc", "looked at every 10 ms, 400 m/s", thin_disc},
    {"A floor of 900 rad/s", "seen every 1/240 s", stroboscope},
    {"A normal of length 2", "not divided by its length", long_normal},
    {"Coincident centres", "between / between.norm()", coincident_centres},
    {"Mass ratio 1e6", "the step that suits the heavy one", step_of_the_heavy_one},
    {"Three balls at once", "pair by pair", pair_by_pair}};

}  // namespace

int main() {
  std::puts("| case | the naive way | measured |\n|---|---|---|");
  for (const Row& row : rows) {
    std::printf("| %s | %s | %s |\n", row.name, row.way, row.measure().c_str());
  }
}
