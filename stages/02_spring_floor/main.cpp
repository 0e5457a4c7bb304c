#include "02_spring_floor/exact.hpp"
#include "02_spring_floor/spring_floor.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<SpringFloor, SpringFloorExact>;

static BallOnALine ball(const Player& player) {
  const SpringFloor scene = static_cast<const Run&>(player.simulation()).scene();
  const auto forces = [scene](double /*t*/, const State<double>& state) {
    const double overlap = std::max(0.0, scene.radius - state.position);
    return ForcesOnALine{-scene.mass * scene.gravity, scene.stiffness * overlap, 0};
  };
  return {.radius = scene.radius, .forces = forces};
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"02_spring_floor", "a ball that bounces on a floor made of a spring"};
  demo.title = "Stage 2: spring floor";
  demo.question = "A softer or a harder floor: on which of them does the ball come back higher?";
  demo.sliders = {"stiffness", "position"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_side_view(demo, ball);
  demo.plots = {
      {"velocity", "m/s", palette::motion, [](const TracePoint& point) { return point.values[1]; },
       [](const TracePoint& point) { return point.exact[1]; }},
      {"energy that the method made",
       "J",
       palette::ink,
       [](const TracePoint& point) { return point.energy_error(); },
       {}}};
  return play(argc, argv, demo);
}
