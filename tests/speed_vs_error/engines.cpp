// The case "engines": which truth belongs to which model, and how far from it each engine is.

#include "speed_vs_error/engines.hpp"

#include <algorithm>
#include <cmath>

#include "03_damping/exact.hpp"
#include "physics/events/event_driven.hpp"
#include "run/one_ball_run.hpp"

namespace bounce::report {
namespace {

constexpr double t_end = 5;                                                     // s
constexpr double time_steps[] = {1.0 / 60, 1.0 / 240, 1e-3, 1.0 / 4000, 1e-4};  // s
constexpr std::size_t tops_compared = 6;

/// The highest point of a flight.
struct Top {
  double t, height;  // s, m
};

/// One model's movement: at the case's times, and at its tops.
struct Movement {
  std::vector<Row> rows;
  std::vector<Top> tops;
};

/// A state at one time, of a movement that is asked step by step.
struct Moment {
  double t, y, v;
};

/// Tops of steps: the highest of three neighbours, and the parabola through them.
std::vector<Top> tops_of(const std::vector<Moment>& steps) {
  std::vector<Top> tops;
  for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
    const double before = steps[i - 1].y, y = steps[i].y, after = steps[i + 1].y;
    if (!(y > before && y >= after)) continue;
    const double curve = before - 2 * y + after, slope = (after - before) / 2;
    const double dt = steps[i + 1].t - steps[i].t;
    tops.push_back({steps[i].t - dt * slope / curve, y - slope * slope / (2 * curve)});
  }
  return tops;
}

// ---- The three truths

Movement spring(ContactLaw law, const std::vector<double>& times) {
  Damping scene;
  scene.contact = law;
  const EventDriven<DampingExact> start(DampingExact(scene), 0, scene.start);
  Movement movement;
  EventDriven<DampingExact> ball = start;
  for (const double t : times) {
    const State<double> state = ball.at(t);
    movement.rows.push_back({state.position, state.velocity});
  }
  for (ball = start; movement.tops.size() < tops_compared;) {
    ball.pass_event();
    const double v = ball.state_at_last_event().velocity, g = scene.gravity;
    if (ball.phase() != Phase::flight) continue;
    movement.tops.push_back({ball.last_event() + v / g, scene.radius + v * v / (2 * g)});
  }
  return movement;
}

/// Of the first impact of the damped ball.
double restitution_of_spring() {
  const Damping scene;
  EventDriven<DampingExact> ball(DampingExact(scene), 0, scene.start);
  ball.pass_event();
  const double down = ball.state_at_last_event().velocity;
  ball.pass_event();
  return -ball.state_at_last_event().velocity / down;
}

/// A ball that bounces in no time, by formula: parabolas between the touches.
class RestitutionBall {
 public:
  explicit RestitutionBall(double restitution) : e_(restitution) {}
  Moment at(double t) {
    while (t >= touch()) bounce();
    const double s = t - from_.t;
    return {t, from_.y + (from_.v - g / 2 * s) * s, from_.v - g * s};
  }
  void bounce() {
    const double t = touch();
    from_ = {t, r, e_ * std::sqrt(from_.v * from_.v + 2 * g * (from_.y - r))};
  }
  Top next_top() const { return {from_.t + from_.v / g, r + from_.v * from_.v / (2 * g)}; }

 private:
  static constexpr double g = Damping{}.gravity, r = Damping{}.radius;
  double touch() const {
    return from_.t + (from_.v + std::sqrt(from_.v * from_.v + 2 * g * (from_.y - r))) / g;
  }
  double e_;
  Moment from_{0, Damping{}.start.position, 0};
};

Movement restitution(double e, const std::vector<double>& times) {
  Movement movement;
  RestitutionBall ball(e);
  for (const double t : times) movement.rows.push_back({ball.at(t).y, ball.at(t).v});
  for (ball = RestitutionBall(e); movement.tops.size() < tops_compared;) {
    ball.bounce();
    movement.tops.push_back(ball.next_top());
  }
  return movement;
}

// ---- Judging

std::function<void(Result&)> judge(const Movement& truth, std::function<Movement()> move) {
  return [truth, move](Result& result) {
    const Movement moved = move();
    result.position_error = result.velocity_error = result.top_error = 0;
    for (std::size_t i = 0; i < truth.rows.size(); ++i) {
      const double y = std::abs(moved.rows[i][0] - truth.rows[i][0]);
      const double v = std::abs(moved.rows[i][1] - truth.rows[i][1]);
      result.position_error = std::max(result.position_error, y);
      result.velocity_error = std::max(result.velocity_error, v);
    }
    if (moved.tops.size() < tops_compared) {  // it lies on the floor before
      result.top_error = result.top_time_error = INFINITY;
      return;
    }
    for (std::size_t i = 0; i < tops_compared; ++i) {
      const double error = std::abs(moved.tops[i].height / truth.tops[i].height - 1);
      result.top_error = std::max(result.top_error, error);
    }
    result.top_time_error = std::abs(moved.tops[tops_compared - 1].t - truth.tops.back().t);
  };
}

Movement movement_of(const std::vector<Moment>& steps, double dt,
                     const std::vector<double>& times) {
  Movement movement{{}, tops_of(steps)};
  for (const double t : times) {  // they are whole numbers of steps
    const Moment& moment = steps[static_cast<std::size_t>(std::lround(t / dt))];
    movement.rows.push_back({moment.y, moment.v});
  }
  return movement;
}

Subject engine_subject(const Engine& engine, double e, double dt, const Movement& truth,
                       const std::vector<double>& times) {
  const auto ball = std::make_shared<std::unique_ptr<EngineBall>>();
  const auto begin = [=] {
    if (!*ball) *ball = engine.make(dt, e);  // building a world is not part of the cost
    (*ball)->drop();
  };
  const long count = std::lround(t_end / dt);
  Subject subject{engine.name, "dt", dt, true, {}, {}};
  subject.run = [=] {
    begin();
    for (long i = 0; i < count; ++i) (*ball)->step();
    return (*ball)->height();
  };
  subject.judge = judge(truth, [=] {
    begin();
    std::vector<Moment> steps{{0, (*ball)->height(), (*ball)->velocity()}};
    for (long i = 1; i <= count; ++i) {
      (*ball)->step();
      steps.push_back({static_cast<double>(i) * dt, (*ball)->height(), (*ball)->velocity()});
    }
    return movement_of(steps, dt, times);
  });
  return subject;
}

/// The slides' loop with the same steps, on its own model.
Subject own_subject(double dt, const Movement& truth, const std::vector<double>& times) {
  const auto ball = std::make_shared<OneBallRun<Damping, DampingExact>>();
  const auto begin = [=] {
    ball->restart();
    ball->use_dt(dt);
  };
  Subject subject{name_of(methods::semi_implicit_euler), "dt", dt, false, {}, {}};
  subject.run = [=] {
    begin();
    ball->advance_to(t_end);
    return ball->state().position;
  };
  subject.judge = judge(truth, [=] {
    begin();
    std::vector<Moment> steps{{0, ball->state().position, 0}};
    while (ball->time() < t_end + dt / 2) {
      ball->advance_one_step();
      steps.push_back({ball->time(), ball->state().position, ball->state().velocity});
    }
    return movement_of(steps, dt, times);
  });
  return subject;
}

std::vector<Engine> installed_engines() {
  std::vector<Engine> engines;
  add_bullet(engines);
  add_ode(engines);
  add_box2d(engines);
  add_mujoco(engines);
  return engines;
}

}  // namespace

std::string engine_versions() {
  std::string all;
  for (const Engine& engine : installed_engines()) {
    const std::string one = engine.name.substr(0, engine.name.find(' ')) + " " + engine.version;
    if (all.find(one) == std::string::npos) all += (all.empty() ? "" : ", ") + one;
  }
  return all.empty() ? "none" : all;
}

Case engines_case() {
  Case one{"engines", 3, "case (b) in rigid-body engines", t_end, {}, {}};
  for (int i = 1; i <= 100; ++i) one.times.push_back(t_end * i / 100);
  const double e = restitution_of_spring();
  const Movement truth = spring(ContactLaw::may_pull, one.times);
  const Movement pushing = spring(ContactLaw::push_only, one.times);
  const Movement instant = restitution(e, one.times);

  // How far the engines' models are from the course's: both by formula, the one judged by the
  // other.
  Subject formula{"restitution by formula", "", 0, false, {}, {}};
  formula.run = [=] { return RestitutionBall(e).at(t_end).y; };
  formula.judge = judge(truth, [=] { return instant; });
  Subject push_only{"exact with push-only", "", 0, false, {}, {}};
  push_only.run = [] {
    Damping scene;
    scene.contact = ContactLaw::push_only;
    return EventDriven<DampingExact>(DampingExact(scene), 0, scene.start).at(t_end).position;
  };
  push_only.judge = judge(truth, [=] { return pushing; });
  one.subjects = {formula, push_only};
  for (const double dt : time_steps) one.subjects.push_back(own_subject(dt, truth, one.times));

  for (const Engine& engine : installed_engines()) {
    for (const double dt : time_steps) {
      const Movement& own = engine.bounce == Bounce::restitution ? instant : pushing;
      one.subjects.push_back(engine_subject(engine, e, dt, own, one.times));
    }
  }
  return one;
}

}  // namespace bounce::report
