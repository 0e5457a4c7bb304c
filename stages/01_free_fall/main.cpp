#include "01_free_fall/exact.hpp"
#include "01_free_fall/free_fall.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<FreeFall, FreeFallExact>;

static BallOnALine ball(const Player& player) {
  const FreeFall scene = static_cast<const Run&>(player.simulation()).scene();
  const auto forces = [scene](double t, const State<double>& state) {
    return ForcesOnALine{scene.force(t, state), 0, 0};
  };
  BallOnALine look{.radius = 0.12, .forces = forces};  // drawn with a radius; the law has none
  look.floor = false;
  look.strobe = true;
  look.lowest = -1.0;
  look.highest = 5.3;
  return look;
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"01_free_fall", "a ball falls, step by step and by formula"};
  demo.title = "Stage 1: free fall";
  demo.question =
      "Make dt a hundred times larger. Where does the ball of the loop end up beside the one of "
      "the formula?";
  demo.sliders = {"mass", "gravity"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_side_view(demo, ball);
  demo.plots = {
      {"velocity", "m/s", palette::motion, [](const TracePoint& point) { return point.values[1]; },
       [](const TracePoint& point) { return point.exact[1]; }},
      {"position minus exact",
       "m",
       palette::ink,
       [](const TracePoint& point) { return point.values[0] - point.exact[0]; },
       {}}};
  demo.is_over = [](const Player& player) { return player.shown_values()[0] < -1.0; };
  return play(argc, argv, demo);
}
