#include "checks/run_check.hpp"

#include <chrono>
#include <numbers>

#include "06_oscillating_floor/exact/exact.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven.hpp"

namespace bounce::check {

namespace {

SpringDamper contact_of(const Setting& s) {
  return {s.stiffness, s.damping, s.push_only ? ContactLaw::push_only : ContactLaw::may_pull};
}

/// What a method of order 1 may miss: g t dt / 2 in flight, and at the touch up to a step of the
/// damper's jump c v, which flies on until the end. Twice that, and two steps' way for the contact.
double order_one(const Setting& s, double speed, double end, double dt) {
  return 2 * dt * (s.gravity * end + speed * (2 + s.damping / s.mass * end));
}

}  // namespace

Run bounce_run(const Setting& s, const Triple& along, double drop, double dt) {
  const double pull = s.gravity * along[1];  // the rest of gravity acts along the floor
  const double speed = std::sqrt(2 * pull * drop), down = speed / pull;
  const double contact = std::numbers::pi / natural_frequency(s.stiffness, s.mass);
  Run run{s, {times(s.radius + drop, along), {}}, dt, 0, along, 0, 0};
  run.steps = std::lround((1.3 * down + 1.5 * contact) / dt);
  EventDriven<BouncePhases> exact(BouncePhases(s.mass, pull, s.radius, contact_of(s)), 0,
                                  {s.radius + drop, 0});
  run.exact = exact.at(run.end()).position;
  run.tolerance = order_one(s, speed, run.end(), dt);
  return run;
}

/// Stage 1: no floor. The loop itself is judged, by its own error: see 01_free_fall_check.cpp.
static Run fall_run(double dt) {
  Setting s;
  Run run{s, {up(5), {}}, dt, std::lround(1 / dt), up(1), 0, 0};
  run.exact = 5 - s.gravity * run.end() * run.end() / 2;
  run.tolerance = s.gravity * run.end() * dt;
  return run;
}

/// Stage 5: ball 1 meets ball 2, which is as heavy and at rest. Seen from each other it is one ball
/// of half the mass on a fixed floor, without gravity; and the middle between them moves on.
Run pair_run(const Setting& setting, const Triple& along, double speed, double dt) {
  Setting s = setting;
  s.gravity = 0;
  s.floor = false;
  const double touch = 2 * s.radius, gap = 0.05;
  const double contact = std::numbers::pi / natural_frequency(s.stiffness, s.mass / 2);
  Run run{s, {times(touch + gap, along), times(-speed, along)}, dt, 0, along, 0, 0};
  run.steps = std::lround((2 * gap / speed + 1.5 * contact) / dt);
  EventDriven<BouncePhases> exact(BouncePhases(s.mass / 2, 0, touch, contact_of(s)), 0,
                                  {touch + gap, -speed});
  const double middle = (touch + gap - speed * run.end()) / 2;
  run.exact = middle + exact.at(run.end()).position / 2;
  run.tolerance = order_one(s, speed, run.end(), dt);
  return run;
}

/// Stage 6: the floor swings.
Run floor_run(const Setting& s, double drop, double dt) {
  OscillatingFloor scene;
  scene.mass = s.mass;
  scene.gravity = s.gravity;
  scene.radius = s.radius;
  scene.stiffness = s.stiffness;
  scene.damping = s.damping;
  scene.contact = contact_of(s).law;
  scene.amplitude = s.amplitude;
  scene.angular_frequency = s.angular_frequency;
  scene.phase = s.phase;
  scene.floor_velocity = s.floor_velocity;
  const double start = s.radius + drop, down = std::sqrt(2 * drop / s.gravity);
  Run run{s, {up(start), {}}, dt, std::lround(1.5 * down / dt), up(1), 0, 0};
  EventDriven<OscillatingFloorExact> exact(OscillatingFloorExact(scene), 0, {start, 0});
  run.exact = exact.at(run.end()).position;
  const double fastest = s.gravity * down + s.amplitude * s.angular_frequency;
  run.tolerance = order_one(s, 2 * fastest, run.end(), dt);
  return run;
}

void judge_runs(const std::string& lesson, const std::vector<Run>& runs) {
  Question<Run> q;
  q.tested = "where the ball is after one bounce, against the exact solution";
  q.unit = "m";
  q.names = {"", "y", ""};
  q.lesson = lesson;
  q.answer = [](const Run& run) { return up(end_of(subject(), run)); };
  q.truth = [](const Run& run) { return up(run.exact); };
  q.rounding = [](const Run& run) { return run.tolerance; };
  q.where = [](const Run& run) {
    return "a ball that starts at " + numbers(run.start.position) + " m; mass " +
           number(run.setting.mass) + ", stiffness " + number(run.setting.stiffness) +
           ", damping " + number(run.setting.damping);
  };
  q.when = [](const Run& run) {
    return "t = " + number(run.end()) + " s, dt = " + number(run.dt) +
           " s (a first-order loop may miss by " + number(run.tolerance) + " m)";
  };
  q.look_at =
      "every single force was right, and yet the run is wrong. Does your code remember something "
      "from one call to the next?";
  judge(q, runs);
}

// ---- Speed against error ------------------------------------------------------------------------

static double nanoseconds_a_step(const Subject& who, const Run& run) {
  constexpr long steps = 40000;
  const auto begin = std::chrono::steady_clock::now();
  for (long done = 0; done < steps; done += run.steps) end_of(who, run);
  const std::chrono::duration<double, std::nano> wall = std::chrono::steady_clock::now() - begin;
  const long rounds = (steps + run.steps - 1) / run.steps;
  return wall.count() / static_cast<double>(rounds * run.steps);
}

static double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

std::vector<SpeedRow> speed_against_error(const Subject& mine, const Subject& course,
                                          const std::vector<Run>& runs) {
  std::vector<SpeedRow> rows;
  for (const Run& run : runs) {
    std::vector<double> ns, course_ns;
    for (int i = 0; i < 15; ++i) {
      ns.push_back(nanoseconds_a_step(mine, run));
      course_ns.push_back(nanoseconds_a_step(course, run));
    }
    rows.push_back({run.dt, std::abs(end_of(mine, run) - run.exact),
                    std::abs(end_of(course, run) - run.exact), median(ns), median(course_ns)});
  }
  return rows;
}

std::vector<Run> speed_runs(int stage) {
  if (stage > 8) return {};  // a stage of your own: nothing is known of its movement
  std::vector<Run> runs;
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    Setting s;
    s.damping = stage == 2 ? 0 : 5;
    switch (stage) {
      case 1:
        runs.push_back(fall_run(dt));
        break;
      case 5:
        runs.push_back(pair_run(s, {0.6, 0.8, 0}, 2, dt));
        break;
      case 6:
        s.damping = 14.17;
        s.amplitude = 0.06;
        s.angular_frequency = 12.6;
        runs.push_back(floor_run(s, 0.7, dt));
        break;
      case 7:
        s.normal = {0.6, 0.8, 0};
        runs.push_back(bounce_run(s, s.normal, 0.5, dt));
        break;
      case 8:
        s.disc_normal = {0.6, 0.8, 0};
        s.disc_radius = 10;
        runs.push_back(bounce_run(s, s.disc_normal, 0.5, dt));
        break;
      default:
        runs.push_back(bounce_run(s, up(1), 0.9, dt));
    }
  }
  return runs;
}

}  // namespace bounce::check
