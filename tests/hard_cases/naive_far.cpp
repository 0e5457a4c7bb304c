// Long, small and far, the naive way.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "02_spring_floor/spring_floor.hpp"
#include "03_damping/damping.hpp"
#include "06_oscillating_floor/exact.hpp"
#include "naive.hpp"
#include "physics/event_driven.hpp"
#include "physics/integrators.hpp"

namespace bounce::naive {
namespace {

std::string resting_on_a_hard_floor() {
  double y = 0.1, v = 0;
  for (int i = 0; i < 10000; ++i) {
    v -= 9.81 * 1e-3;
    y += v * 1e-3;
    if (y < 0.1) v = -0.8 * v;
  }
  return "`if (y < r) v = -0.8 * v`, the loop of many games, lets it sink: by " +
         digits(100 * (0.1 - y), 2) + " cm in 10 s";
}

std::string time_added_up() {
  double t = 0;
  for (int i = 0; i < 10000000; ++i) t += 0.1;
  const double late = std::abs(t - 1e6);
  return "`t += dt`: after 1e7 steps of 0.1 s the clock is " + digits(late, 2) +
         " s off, and a swing of 100 rad/s " + digits(late * 100, 2) + " rad";
}

std::string angle_of_a_late_time() {
  const double w = 62.83, t = 1e6;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double now = t + i * 0.0137;
    const long double right = static_cast<long double>(w) * static_cast<long double>(now);
    const auto error = static_cast<double>(std::abs(right - static_cast<long double>(w * now)));
    worst = std::max(worst, error);
  }
  return "w t is rounded by up to " + digits(worst, 2) +
         " rad, and a search for the touch sees that as jumps of the floor";
}

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

std::string hops_of_a_hard_floor() {
  double t = 0, v = 4;
  int hops = 0;
  for (double before = -1; t > before; ++hops) {
    before = t;
    t += 2 * v / 9.81;
    v *= 0.9;
  }
  return "a hard floor has infinitely many hops; at a restitution of 0.9 the clock stops after " +
         std::to_string(hops);
}

std::string events_that_stand_still() {
  double t = 0, v = 4;
  for (int i = 0; t < 10 && i < 1000000; ++i) {
    t += 2 * v / 9.81;
    v *= 0.9;
  }
  return "`while (t < 10) t += 2 * v / g` over a hard floor: a million hops later the clock stands "
         "at " +
         digits(t) + " s";
}

std::string hovering() {
  OscillatingFloor scene;
  scene.floor_law = FloorLaw::absolute;
  scene.damping = 300;
  scene.angular_frequency = 1;
  EventDriven<OscillatingFloorExact> walker(OscillatingFloorExact(scene), 0, scene.start);
  std::vector<double> events;
  try {
    while (walker.next_event() != never) {
      walker.pass_event();
      events.push_back(walker.last_event());
    }
  } catch (const TimeStandsStill&) {
  }
  const double last_ones = events.back() - events[events.size() - 1000];
  return "from event to event, ever shorter hops: the last thousand take " + digits(last_ones, 1) +
         " s";
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

std::string back_with_explicit_euler() {
  const SpringFloor scene;
  State<double> ball = scene.start;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  ball.velocity = -ball.velocity;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  return "explicit Euler, 3 s and back, misses the start by " +
         digits(std::abs(ball.position - scene.start.position), 2) + " m";
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

/// As printf writes a double that is not asked for more.
double in_six_digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return std::strtod(text, nullptr);
}

std::string saved_with_six_digits() {
  const Damping scene;
  State<double> ball = scene.start, restarted = ball;
  for (int i = 0; i < 5000; ++i) {
    if (i == 1000) restarted = {in_six_digits(ball.position), in_six_digits(ball.velocity)};
    semi_implicit_euler(scene, 0, ball, 1e-3);
    if (i >= 1000) semi_implicit_euler(scene, 0, restarted, 1e-3);
  }
  return "saved with `printf(\"%g\")` after 1 s, the ball is " +
         digits(std::abs(restarted.position - ball.position), 1) + " m elsewhere after 5 s";
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
  print_cases({{"Resting for 1e6 s", resting_on_a_hard_floor},
               {"A resting swing after 1e6 s", time_added_up},
               {"sin(w t) at t = 1e6 s", angle_of_a_late_time},
               {"A drop from 1e-9 m", drop_from_a_nanometre},
               {"A near miss by 1e-9 m", near_miss_with_a_tolerance},
               {"Bounces to rest", hops_of_a_hard_floor},
               {"Events that no longer advance time", events_that_stand_still},
               {"Hovering on the edge of an unphysical contact (stage 6, `absolute` and `slides`)",
                hovering},
               {"A start deep in the floor", pushed_out_at_once},
               {"A start with the centre below the floor", centre_below},
               {"Coordinates of 1e7 m", far_in_single_precision},
               {"Denormal velocity", time_to_a_denormal_end},
               {"Time reversal without a damper", back_with_explicit_euler},
               {"Units scaled by powers of two", constant_in_metres},
               {"Restart from a saved state", saved_with_six_digits},
               {"A saved state with a speed of 1e308 m/s", speed_beyond_reason}});
}

}  // namespace bounce::naive
