#include "05_ball_collision/picture/balls_picture.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "05_ball_collision/run/command_line.hpp"
#include "app/demo.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo;
  demo.make = [] { return std::make_unique<BallsRun>(); };
  if constexpr (has_picture) use_balls_picture(demo);
  demo.stage = {"05_ball_collision", "balls that bounce off each other, a floor and walls"};
  demo.title = "Stage 5: ball against ball";
  demo.question =
      "Choose the tower. How high does the small ball fly when the two touch, and how high with a "
      "gap of 0.1 m between them?";
  demo.sliders = {"scene", "gap", "count"};
  demo.plots = {plot_kinetic_energy("energy of motion"),
                plot_spring_energy("energy in the springs")};
  demo.options = ball_collision_options();
  demo.other_work = with_files([&demo](Simulation& simulation, const Options& options) {
    return export_lammps(demo.stage, simulation, options);
  });
  return play(argc, argv, demo);
}
