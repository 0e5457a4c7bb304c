#include "run/error_chart.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "01_free_fall/exact.hpp"
#include "03_damping/exact.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using test::set;

namespace {

using Fall = OneBallRun<FreeFall, FreeFallExact>;
using Damped = OneBallRun<Damping, DampingExact>;

ErrorChart chart_of(const Simulation& simulation) {
  ErrorChart chart;
  chart.follow(simulation, 0);
  chart.work(1e9);
  REQUIRE(chart.trouble() == "");
  REQUIRE(chart.is_done());
  return chart;
}

std::vector<ErrorChart::Dot> dots_of(const ErrorChart& chart, Method method) {
  std::vector<ErrorChart::Dot> dots;
  for (const ErrorChart::Dot& dot : chart.dots()) {
    if (dot.method == method) dots.push_back(dot);
  }
  return dots;
}

}  // namespace

TEST_CASE("the error chart of a free fall shows what the formulas say") {
  const ErrorChart chart = chart_of(Fall());
  CHECK(chart.duration() == 2);
  for (const Method method : {methods::explicit_euler, methods::semi_implicit_euler}) {
    const std::vector<ErrorChart::Dot> dots = dots_of(chart, method);
    CHECK(dots.size() == 6);
    for (const ErrorChart::Dot& dot : dots) {
      CAPTURE(dot.dt);
      // g t dt / 2, and the last sample's step ends at most one step after 2 s.
      const double error = 9.81 * 2 * dot.dt / 2;
      CHECK(dot.error >= error * (1 - 1e-6));
      CHECK(dot.error <= error * (1 + dot.dt / 2 + 1e-6));
      CHECK(dot.evaluations == doctest::Approx(1 / dot.dt).epsilon(1e-9));
    }
  }
  for (const ErrorChart::Dot& dot : dots_of(chart, methods::rk4)) {
    CHECK(dot.error < 1e-11);  // rounding of at most 2e5 steps
    CHECK(dot.evaluations == doctest::Approx(4 / dot.dt).epsilon(1e-9));
  }
}

TEST_CASE("the error chart of a damped bounce is what a plain loop finds, step for step") {
  const ErrorChart chart = chart_of(Damped());
  const Damping p;
  for (const ErrorChart::Dot& dot : dots_of(chart, methods::semi_implicit_euler)) {
    CAPTURE(dot.dt);
    EventDriven<DampingExact> exact(DampingExact(p), 0, p.start);
    double y = p.start.position, v = 0, worst = 0;
    long n = 0;
    for (int sample = 1; sample <= 50; ++sample) {
      const double until = chart.duration() * sample / 50;
      for (; static_cast<double>(n) * dot.dt < until - 1e-6 * dot.dt; ++n) {
        double F = -p.mass * p.gravity;
        if (y < p.radius) F += p.stiffness * (p.radius - y) - p.damping * v;
        v += F / p.mass * dot.dt;
        y += v * dot.dt;
      }
      const double right = exact.at(static_cast<double>(n) * dot.dt).position;
      worst = std::max(worst, std::abs(y - right));
    }
    // The same bits, but for the time at which they are compared: n dt, rounded (v < 5 m/s).
    CHECK(dot.error == doctest::Approx(worst).epsilon(1e-9));
  }
  // Located events: at the smallest step more accurate than any plain method, by a lot.
  const auto best = [&chart](Method method) {
    double least = 1;
    for (const ErrorChart::Dot& dot : dots_of(chart, method)) least = std::min(least, dot.error);
    return least;
  };
  CHECK(best(methods::flight_rk4) < 1e-4 * best(methods::rk4));
  CHECK(best(methods::rk4_events) < 1e-4 * best(methods::rk4));
}

TEST_CASE("the error chart of two balls compares with the reference, for four touches") {
  const ErrorChart chart = chart_of(BallsRun());
  CHECK(chart.duration() == doctest::Approx(4 * 0.4).epsilon(1e-9));  // 0.4 m at 1 m/s
  for (const Method method :
       {methods::semi_implicit_euler, methods::velocity_verlet, methods::rk4}) {
    const std::vector<ErrorChart::Dot> dots = dots_of(chart, method);
    REQUIRE(dots.size() >= 4);  // finer steps would take too long
    CAPTURE(name_of(method));
    // The touch is seen up to a step late, in which the first ball goes on with 1 m/s.
    CHECK(dots.back().error < dots.back().dt);
    CHECK(dots.back().error > 1e-12);  // without located events the touch costs accuracy
  }
  BallsRun crowd;
  set(crowd, "scene", "break");
  crowd.restart();
  ErrorChart none;
  none.follow(crowd, 0);
  CHECK(none.trouble() != "");
}

TEST_CASE("the error chart follows the simulation: its step, its method, its parameters") {
  Damped ball;
  ball.use_dt(2.5e-4);  // none of the chart's own
  ErrorChart chart = chart_of(ball);
  REQUIRE(chart.now());
  CHECK(chart.now()->dt == 2.5e-4);
  const std::size_t all = chart.dots().size();

  ball.use_method(methods::rk4);
  ball.use_dt(1e-3);  // one of its own: nothing to be computed
  chart.follow(ball, 0);
  CHECK(chart.is_done());
  CHECK(chart.now()->method == methods::rk4);
  CHECK(chart.dots().size() == all);

  const double before = chart.now()->error;
  const std::vector<Parameter> parameters = ball.parameters();
  find_parameter(parameters, "stiffness").set("2000");
  chart.follow(ball, 3);  // still moving
  CHECK(chart.dots().size() == all);
  for (int i = 0; i < 4; ++i) chart.follow(ball, 3);
  CHECK(!chart.is_done());
  CHECK(!chart.now());
  chart.work(1e9);
  REQUIRE(chart.now());
  CHECK(chart.now()->error != before);

  ball.use_method(methods::exact);
  chart.follow(ball, 0);
  CHECK(chart.is_done());
  CHECK(!chart.now());
}

TEST_CASE("the error chart computes in portions, and leaves out what would take too long") {
  ErrorChart chart;
  chart.follow(Damped(), 0);
  int portions = 0;
  while (!chart.is_done() && portions < 100000) {
    chart.work(1e-6);
    ++portions;
  }
  CHECK(chart.is_done());
  CHECK(portions > 300);  // 36 runs with 50 samples each, one or a few at a time

  Damped hard;
  const std::vector<Parameter> parameters = hard.parameters();
  find_parameter(parameters, "stiffness").set("1e12");
  hard.use_dt(1e-7);
  ErrorChart empty;
  empty.follow(hard, 0);
  empty.work(1e9);
  CHECK(empty.is_done());
  CHECK(empty.trouble() == "");
  CHECK(!empty.now());
}

TEST_CASE("a step that explodes is in the error chart with an infinite error") {
  Damped ball;
  ball.use_method(methods::explicit_euler);
  ball.use_dt(0.05);
  const ErrorChart chart = chart_of(ball);
  REQUIRE(chart.now());
  CHECK(chart.now()->error > 10);
}
