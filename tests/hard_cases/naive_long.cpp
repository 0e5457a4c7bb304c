// Long runs, the naive way.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "02_spring_floor/spring_floor.hpp"
#include "03_damping/damping.hpp"
#include "06_oscillating_floor/exact/exact.hpp"
#include "naive.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/stepping_methods.hpp"

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

std::string back_with_explicit_euler() {
  const SpringFloor scene;
  State<double> ball = scene.start;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  ball.velocity = -ball.velocity;
  for (int i = 0; i < 3000; ++i) explicit_euler(scene, 0, ball, 1e-3);
  return "explicit Euler, 3 s and back, misses the start by " +
         digits(std::abs(ball.position - scene.start.position), 2) + " m";
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

}  // namespace

void print_long() {
  print_cases(
      {{"Resting for 1e6 s", resting_on_a_hard_floor},
       {"A resting swing after 1e6 s", time_added_up},
       {"sin(w t) at t = 1e6 s", angle_of_a_late_time},
       {"Bounces to rest", hops_of_a_hard_floor},
       {"Events that no longer advance time", events_that_stand_still},
       {"Hovering on the edge of an unphysical contact (stage 6, `absolute` and `fixed-switch`)",
        hovering},
       {"Time reversal without a damper", back_with_explicit_euler},
       {"Restart from a saved state", saved_with_six_digits}});
}

}  // namespace bounce::naive
