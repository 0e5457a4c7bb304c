#include "05_ball_collision/picture/balls_picture.hpp"
#include "05_ball_collision/run/balls_simulation.hpp"
#include "05_ball_collision/run/options.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"05_ball_collision", "balls that bounce off each other, a floor and walls"};
  demo.title = "Stage 5: ball against ball";
  demo.question =
      "Choose the tower. How high does the small ball fly when the two touch, and how high with a "
      "gap of 0.1 m between them?";
  demo.sliders = {"scene", "gap", "count"};
  demo.make = [] { return std::make_unique<BallsSimulation>(); };
  demo.options = ball_collision_options();
  demo.other_work = [&demo](Simulation& simulation, const Options& options) {
    return export_lammps(demo.stage, static_cast<BallsSimulation&>(simulation), options);
  };
  use_balls_picture(demo);
  demo.plots = {{"energy of motion",
                 "J",
                 palette::motion,
                 [](const TracePoint& point) { return point.energy.kinetic; },
                 {}},
                {"energy in the springs",
                 "J",
                 palette::spring,
                 [](const TracePoint& point) { return point.energy.spring; },
                 {}}};
  return play(argc, argv, demo);
}
