#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/space_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<ThreeDimensions, ThreeDimensionsExact>;

static BallInSpace ball(const Player& player) {
  const ThreeDimensions scene = static_cast<const Run&>(player.simulation()).scene();
  BallInSpace look;
  look.radius = scene.radius;
  look.has_plane = scene.floor;
  look.forces = [scene](const State<Eigen::Vector3d>& state) {
    return ForcesInSpace{{0, -scene.mass * scene.gravity, 0},
                         {0, scene.spring_force(state), 0},
                         scene.damper_force(0, state)};
  };
  return look;
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"04_three_dimensions", "a ball thrown over a floor in three dimensions"};
  demo.title = "Stage 4: three dimensions";
  demo.question =
      "Press T and look from straight above. Which path does the ball draw there, and how fast "
      "does "
      "it go?";
  demo.sliders = {"velocity", "damping"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_space_view(demo, ball);
  demo.plots = {
      {"velocity along y (up)", "m/s", palette::motion,
       [](const TracePoint& point) { return point.values[4]; },
       [](const TracePoint& point) { return point.exact[4]; }},
      {"velocity along x", "m/s", palette::motion,
       [](const TracePoint& point) { return point.values[3]; },
       [](const TracePoint& point) { return point.exact[3]; }},
  };
  demo.is_over = [](const Player& player) {  // without a floor it falls for ever
    return !static_cast<const Run&>(player.simulation()).scene().floor &&
           player.shown_values()[1] < -3;
  };
  return play(argc, argv, demo);
}
