// The cases, and the course's own methods on them.

#include <cmath>
#include <memory>

#include "01_free_fall/exact.hpp"
#include "02_spring_floor/exact.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "06_oscillating_floor/exact/exact.hpp"
#include "07_tilted_plane/exact.hpp"
#include "run/one_ball_run.hpp"
#include "speed_vs_error/bounce_batch.hpp"
#include "speed_vs_error/subjects.hpp"

namespace bounce::report {
namespace {

template <class Vector>
Row row_of(const State<Vector>& state) {
  Row row;
  for (const double number : components(state.position)) row.push_back(number);
  for (const double number : components(state.velocity)) row.push_back(number);
  return row;
}

template <class Vector>
State<Vector> state_of(const Row& row) {
  State<Vector> state;
  std::size_t i = 0;
  for (double& number : components(state.position)) number = row[i++];
  for (double& number : components(state.velocity)) number = row[i++];
  return state;
}

template <class Scene, class Exact>
Subject exact_subject(const Scene& scene, double t_end) {
  using Vector = decltype(Scene::start.position);
  using Walker = EventDriven<Exact, Vector>;
  Subject subject{"exact", "", 0, false, {}, {}};
  subject.sample = [=](const std::vector<double>& times) {
    Walker walker(Exact(scene), 0, scene.start);
    std::vector<Row> rows;
    for (const double t : times) rows.push_back(row_of(walker.at(t)));
    return rows;
  };
  subject.run = [=] {
    Walker walker(Exact(scene), 0, scene.start);
    const State<Vector> end = walker.at(t_end);
    return components(end.position)[0];
  };
  return subject;
}

// A sweep over the height of the start, side by side in the lanes of the vector units. Its first
// ball is the case's own.
Subject sweep_subject(double damping, double t_end) {
  constexpr int count = 1024;
  const Damping p;
  std::vector<SweepBall> balls;
  for (int i = 0; i < count; ++i) {
    const State<double> start{p.start.position * (1 + 1e-4 * i), p.start.velocity};
    balls.push_back({p.mass, p.gravity, p.radius, {p.stiffness, damping}, start});
  }
  Subject subject{"exact in lanes", "", 0, false, {}, {}};
  subject.sample = [first = balls[0]](const std::vector<double>& times) {
    std::vector<Row> rows;
    for (const double t : times) {
      rows.push_back(row_of(exact_states(std::vector<SweepBall>(lanes::count, first), t)[0]));
    }
    return rows;
  };
  subject.run = [=] { return exact_states(balls, t_end)[0].position; };
  subject.balls = count;
  return subject;
}

template <class Scene, class Exact>
Subject stepping_subject(const OneBallRun<Scene, Exact>& simulation, Method method, double dt,
                         double t_end) {
  const auto run = std::make_shared<OneBallRun<Scene, Exact>>(simulation);
  const bool by_tolerance = method == methods::reference;
  Subject subject{name_of(method), by_tolerance ? "tolerance" : "dt", dt, false, {}, {}};
  const auto begin = [=] {
    run->restart();
    run->use_method(method);
    if (by_tolerance) {
      run->use_tolerance(dt);
    } else {
      run->use_dt(dt);
    }
  };
  subject.sample = [=](const std::vector<double>& times) {
    begin();
    std::vector<Row> rows;
    for (const double t : times) {
      try {
        run->advance_to(t);
      } catch (const NonFinite&) {  // too large a step: the rows end here
        break;
      }
      rows.push_back(row_of(run->state()));
    }
    return rows;
  };
  subject.run = [=] {
    begin();
    run->advance_to(t_end);
    return components(run->state().position)[0];
  };
  subject.evaluations = [=] {
    begin();
    run->advance_to(t_end);
    return run->steps() * method.evaluations + run->counted_force_evaluations();
  };
  return subject;
}

// The program of the slides with nothing around it: what the library's step is compared with.
Subject bare_loop(const Damping& p, double dt, double t_end) {
  Subject subject{"bare loop", "dt", dt, false, {}, {}};
  subject.run = [=] {
    const double m = p.mass, g = p.gravity, k = p.stiffness, c = p.damping, r = p.radius;
    const long steps = std::lround(t_end / dt);
    double y = p.start.position, v = p.start.velocity;
    for (long i = 0; i < steps; ++i) {
      double F = -m * g;
      if (y < r) F += k * (r - y) - c * v;
      v += F / m * dt;
      y += v * dt;
    }
    return y;
  };
  return subject;
}

template <class Scene, class Exact>
Case case_of(const std::string& name, int stage, const std::string& what, double t_end) {
  Case one{name, stage, what, t_end, {}, {}};
  using Vector = decltype(Scene::start.position);
  const OneBallRun<Scene, Exact> simulation;
  const Scene scene = simulation.scene();
  for (int i = 1; i <= 100; ++i) one.times.push_back(t_end * i / 100);
  one.energy = [scene](double t, const Row& row) {
    const State<Vector> state = state_of<Vector>(row);
    if constexpr (requires { scene.energy(t, state); }) return scene.energy(t, state).total();
    if constexpr (requires { scene.energy(state); }) return scene.energy(state).total();
  };
  one.subjects.push_back(exact_subject<Scene, Exact>(scene, t_end));
  one.truth = one.subjects[0].sample(one.times);
  for (const Method method : simulation.methods()) {
    if (method == methods::exact) continue;
    if (method == methods::reference) {
      for (const double tolerance : geometric(1e-3, 1e-14, 2)) {
        one.subjects.push_back(
            stepping_subject<Scene, Exact>(simulation, method, tolerance, t_end));
      }
      continue;
    }
    // From about the largest stable step of these contacts on.
    for (const double dt : geometric(1e-2, method == methods::rk4_events ? 1e-5 : 2e-6, 6)) {
      one.subjects.push_back(stepping_subject<Scene, Exact>(simulation, method, dt, t_end));
    }
  }
  return one;
}

}  // namespace

std::vector<double> geometric(double coarsest, double finest, int each) {
  std::vector<double> values;
  for (int i = 0;; ++i) {
    const double value = coarsest * std::pow(10, -static_cast<double>(i) / each);
    if (value < finest * (1 - 1e-9)) return values;
    values.push_back(value);
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back(case_of<FreeFall, FreeFallExact>("fall", 1, "a ball that falls from 5 m, 1 s", 1));
  all.push_back(case_of<SpringFloor, SpringFloorExact>(
      "bounce", 2, "case (a): an undamped ball from 1 m, 10 s, 11 bounces", 10));
  all.back().subjects.push_back(sweep_subject(0, 10));
  all.push_back(case_of<Damping, DampingExact>(
      "damped", 3, "case (b): a damped ball from 1 m, 5 s, 7 bounces", 5));
  all.back().subjects.push_back(sweep_subject(5, 5));
  all.back().subjects.push_back(bare_loop(Damping{}, 1e-4, 5));
  all.push_back(case_of<ThreeDimensions, ThreeDimensionsExact>(
      "space", 4, "the damped ball, thrown sideways, 5 s", 5));
  all.push_back(case_of<OscillatingFloor, OscillatingFloorExact>(
      "shaken", 6, "a damped ball on a floor that moves up and down, 2 s", 2));
  all.push_back(case_of<TiltedPlane, TiltedPlaneExact>("tilted", 7,
                                                       "a damped ball on a tilted plane, 2 s", 2));
  return all;
}

}  // namespace bounce::report
