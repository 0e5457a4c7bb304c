// A learner's own method in a run, as `./course play N --mine` puts it there: here it is velocity
// Verlet, so that the course's is the measure.
#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include "physics/state.hpp"

namespace bounce {
namespace {
template <class Vector>
struct MyMethod {
  std::optional<Vector> acceleration;

  template <class Scene>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    if (!acceleration) acceleration = scene.acceleration(t, state);
    state.velocity += *acceleration * (dt / 2);
    state.position += state.velocity * dt;
    *acceleration = scene.acceleration(t + dt, state);
    state.velocity += *acceleration * (dt / 2);
  }
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("acceleration", self.acceleration);
  }
};
}  // namespace
}  // namespace bounce

#define BOUNCE_MY_METHOD
#include "02_spring_floor/exact.hpp"
#include "run/error_chart.hpp"
#include "run/one_ball_run.hpp"

using namespace bounce;

namespace {

// Types of this file alone: the other files' runs know no such method.
struct MyFloor : SpringFloor {};
struct MyPhases : SpringFloorExact {
  using SpringFloorExact::SpringFloorExact;
};
using MyRun = OneBallRun<MyFloor, MyPhases>;

}  // namespace

TEST_CASE("a learner's own method moves a run from the start, and what it costs is counted") {
  MyRun mine, course;
  CHECK(mine.method() == methods::mine);
  course.use_method(methods::velocity_verlet);
  for (MyRun* run : {&mine, &course}) {
    run->use_dt(1e-3);
    run->restart();
    run->advance_to(2);
  }
  CHECK(mine.values() == course.values());
  CHECK(mine.counted_force_evaluations() == mine.steps() + 1);  // one more before the first step
  CHECK(mine.memory().numbers == course.memory().numbers);
  MyRun loaded;
  loaded.recall(mine.memory());
  loaded.advance_to(2.5);
  mine.advance_to(2.5);
  CHECK(loaded.values() == mine.values());
}

TEST_CASE("a learner's own method stands on the chart of speed against error beside the others") {
  ErrorChart chart;
  chart.follow(MyRun(), 0);
  chart.work(1e9);
  REQUIRE(chart.is_done());
  std::vector<ErrorChart::Dot> mine, course;
  for (const ErrorChart::Dot& dot : chart.dots()) {
    if (dot.method == methods::mine) mine.push_back(dot);
    if (dot.method == methods::velocity_verlet) course.push_back(dot);
  }
  REQUIRE(mine.size() > 3);
  REQUIRE(mine.size() == course.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    CHECK(mine[i].error == course[i].error);
    CHECK(mine[i].evaluations ==
          doctest::Approx(course[i].evaluations + 1 / chart.duration()).epsilon(0.01));
  }
}
