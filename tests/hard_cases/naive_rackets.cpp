// Rackets, the naive way.

#include <Eigen/Core>
#include <cmath>

#include "08_racket_game/racket_game.hpp"
#include "naive.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::naive {
namespace {

using Eigen::Vector3d;
using Ball = State<Vector3d>;

Racket undamped_racket() {
  Racket scene;
  scene.gravity = 0;
  scene.damping = 0;
  return scene;
}

/// Moves the ball by so many steps; the side of the racket is where the centre is at each.
void look_at_steps(Racket scene, Ball& ball, double dt, int steps) {
  for (int i = 0; i < steps; ++i) {
    scene.side = scene.disc_at(i * dt).height(ball.position) < 0 ? -1 : 1;
    semi_implicit_euler(scene, i * dt, ball, dt);
  }
}

std::string thin_disc() {
  int through = 0;
  for (int i = 0; i < 1000; ++i) {
    Racket scene = undamped_racket();
    scene.stiffness = 1e8;
    scene.disc.radius = 1;
    Ball ball{{0.1, 1 + i * 0.004, 0}, {0, -400, 0}};
    look_at_steps(scene, ball, 0.01, 10);
    through += ball.velocity.y() == -400 ? 1 : 0;
  }
  return "looked at every 10 ms, " + std::to_string(through) +
         " of 1000 balls pass it without a touch";
}

std::string fast_racket() {
  int missed = 0, wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    Racket scene = undamped_racket();
    scene.mass = 0.06, scene.radius = 0.03, scene.stiffness = 9000;
    scene.disc.velocity = {0, 15, 0};
    Ball ball{{0, 0.5 + i * 0.00015, 0}, {0, 0, 0}};
    look_at_steps(scene, ball, 0.01, 30);
    const double speed = ball.velocity.y();
    missed += speed == 0 ? 1 : 0;
    wrong += speed != 0 && std::abs(speed / 30 - 1) > 0.1 ? 1 : 0;
  }
  return "a racket at 15 m/s, looked at every 10 ms, misses " + std::to_string(missed) +
         " of 1000 balls, and throws " + std::to_string(wrong) + " at a speed wrong by over 10 %";
}

std::string one_sided() {
  Racket scene = undamped_racket();
  Ball ball{{0, -0.3, 0}, {0, 5, 0}};
  for (int i = 0; i < 1000; ++i) semi_implicit_euler(scene, 0, ball, 1e-4);  // side stays 1
  return "`y < r` holds below as well: a ball that comes up at 5 m/s is pulled through, and leaves "
         "at " +
         digits(ball.velocity.y(), 2) + " m/s";
}

/// The plane of stage 7, level, that ends at the rim.
struct CutOff {
  double rim = 0.3;  // m
  bool touches(const Vector3d& ball) const { return ball.y() < 0.1 && ball.x() < rim; }
  Vector3d acceleration(double /*t*/, const Ball& ball) const {
    return {0, touches(ball.position) ? 1e4 * (0.1 - ball.position.y()) : 0, 0};
  }
  double energy(const Ball& ball) const {
    const double overlap = touches(ball.position) ? 0.1 - ball.position.y() : 0;
    return ball.velocity.squaredNorm() / 2 + 1e4 * overlap * overlap / 2;
  }
};

std::string rim() {
  const CutOff scene;
  const auto push = [&](double x) { return scene.acceleration(0, {{x, 0.05, 0}, {}}).y(); };
  return "a plane cut off at the rim: 5 cm deep, the push falls from " + digits(push(0.3 - 1e-9)) +
         " N to " + digits(push(0.3 + 1e-9)) + " within 2e-9 m";
}

std::string sideways() {
  const CutOff scene;
  Ball ball{{0.299, 0.05, 0}, {2, -0.5, 0}};
  const double before = scene.energy(ball);
  for (int i = 0; i < 1000; ++i) rk4(scene, 0, ball, 1e-5);
  return "over the edge of a plane that is cut off, " + digits(before - scene.energy(ball), 2) +
         " J of " + digits(before, 2) + " J are gone";
}

std::string through_the_disc() {
  Racket scene;
  scene.damping = 0;
  Ball ball{{0.2999, -0.03, 0}, {3, 0, 0}};
  const double before = scene.energy(0, ball).total();
  for (int i = 0; i < 10000; ++i) rk4(scene, 0, ball, 1e-6);  // `through` is not remembered
  return "the nearest point jumps to the rim and the push turns round: " +
         digits(before - scene.energy(0, ball).total(), 2) + " J of " + digits(before, 2) +
         " J are lost";
}

std::string graze() {
  int unseen = 0;
  for (int i = 0; i < 1000; ++i) {
    Racket scene = undamped_racket();
    const double beside = scene.disc.radius + scene.radius - 1e-5;
    Ball ball{{beside, 0, -0.3 + i * 3e-5}, {0, 0, 3}};
    look_at_steps(scene, ball, 0.01, 20);
    unseen += ball.velocity.x() == 0 ? 1 : 0;
  }
  return "looked at every 10 ms, " + std::to_string(unseen) + " of 1000 balls at 3 m/s pass unseen";
}

std::string millions_of_pieces() {
  Racket scene;
  scene.mass = 1e-30;
  scene.stiffness = 1e30;
  Ball ball{{0, 0.05, 0}, {0, 0, 0}};
  const double piece = 1e-3 / 1e30;  // omega0 dt = 1e-3
  double t = 0;
  for (int i = 0; i < 100000; ++i, t += piece) rk4(scene, 0, ball, piece);
  return "a hundred thousand pieces of it bring a step of 1 ms on by " + digits(t, 1) +
         " s, and it hears no interrupt";
}

}  // namespace

void print_rackets() {
  print_cases({{"A thin disc at 400 m/s, 10 ms a step", thin_disc},
               {"A racket faster than r/dt", fast_racket},
               {"A racket from below, a ball from below", one_sided},
               {"The rim", rim},
               {"A graze of the rim, 1e-5 m deep", graze},
               {"Sideways off the racket during contact", sideways},
               {"With its centre through the disc, and out over the rim", through_the_disc},
               {"A step in contact that would take years: m = 1e-30, k = 1e30; dt = 1e10",
                millions_of_pieces}});
}

}  // namespace bounce::naive
