#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<Damping, DampingExact>;

static BallOnALine ball(const Player& player) {
  const Damping scene = static_cast<const Run&>(player.simulation()).scene();
  const auto forces = [scene](double t, const State<double>& state) {
    return ForcesOnALine{-scene.mass * scene.gravity,
                         std::max(0.0, scene.stiffness * (scene.radius - state.position)),
                         scene.damper_force(t, state)};
  };
  return {.radius = scene.radius, .forces = forces};
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"03_damping", "a ball on a floor with spring and damper"};
  demo.title = "Stage 3: damping";
  demo.question =
      "How much damping lets the ball come back to half its height? And how much makes it stay "
      "down?";
  demo.sliders = {"damping", "stiffness", "contact"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_side_view(demo, ball);
  demo.plots = {
      {"velocity", "m/s", palette::motion, [](const TracePoint& point) { return point.values[1]; },
       [](const TracePoint& point) { return point.exact[1]; }},
      {"energy lost to the damper",
       "J",
       palette::damper,
       [](const TracePoint& point) { return point.lost; },
       {}}};
  return play(argc, argv, demo);
}
