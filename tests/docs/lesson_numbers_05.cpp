// The numbers of stage 5, computed with the library. usage: lesson_numbers_05 TABLE
// Its pages name them in <!-- value: ... --> (lesson_tool.hpp).

#include <algorithm>
#include <cstdio>

#include "05_ball_collision/run/balls_world.hpp"
#include "05_ball_collision/scenes/scenes.hpp"
#include "docs/tables.hpp"
#include "physics/methods/semi_implicit_euler.hpp"

using namespace bounce;

namespace {

/// How high the small ball flies that fell with the big one: in heights of the fall, above where it
/// is when both lie on the floor.
double flight(double gap, double stiffness_of_balls, double dt) {
  const Arrangement start = tower(gap);
  BallCollision scene;
  scene.mass = start.mass;
  scene.radius = start.radius;
  scene.stiffness = stiffness_of_balls;
  scene.floor_stiffness = 1e5;
  State<Eigen::Matrix3Xd> balls = start.balls;
  double top = 0;
  bool thrown = false;
  for (long n = 0; !thrown || balls.velocity(1, 1) > 0; ++n) {
    semi_implicit_euler(scene, static_cast<double>(n) * dt, balls, dt);
    thrown = thrown || balls.velocity(1, 1) > 1;
    if (thrown) top = std::max(top, balls.position(1, 1));
  }
  return (top - 2 * scene.radius[0] - scene.radius[1]) / 0.8;
}

void tower_heights() {
  std::printf("| gap [m] | stiffness of the balls [N/m] | heights of the fall |\n|---|---|---|\n");
  std::printf("| 0 | 1e5 | %.2f |\n", flight(0, 1e5, 1e-3));
  std::printf("| 0.1 | 1e5 | %.2f |\n", flight(0.1, 1e5, 1e-3));
  std::printf("| 0 | 1e6 | %.2f |\n", flight(0, 1e6, 1e-4));
}

/// 27 balls dropped into a tray, one of them moved aside by so much at the start [m].
BallsRun heap(double aside, bool damped) {
  BallsRun run;
  const auto set = [&](const char* name, const char* value) {
    find_parameter(run.parameters(), name).set(value);
  };
  set("scene", "drop");
  set("count", "27");
  if (!damped) {
    set("damping", "0");
    set("floor_damping", "0");
  }
  run.use_dt(1e-4);
  run.restart();
  std::vector<double> rows = run.values();
  rows[1] += aside;
  run.place(rows);
  return run;
}

/// How two heaps part that differ by a hair: when the ball that is furthest off is so far away.
void growth() {
  BallsRun all[] = {heap(0, false), heap(1e-12, false), heap(0, true), heap(1e-12, true)};
  std::printf(
      "| after [s] | without dampers [m] | as it comes, with dampers [m] |\n|---|---|---|\n");
  for (const double t : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}) {
    for (BallsRun& run : all) run.advance_to(t);
    const auto apart = [&](int i) {
      return largest_distance(all[i].state().position, all[i + 1].state().position);
    };
    std::printf("| %.1f | %.1e | %.1e |\n", t, apart(0), apart(2));
  }
}

const bounce::test::Table tables[] = {{"tower", tower_heights}, {"growth", growth}};

}  // namespace

int main(int argc, char** argv) { return bounce::test::print_table(tables, argc, argv); }
