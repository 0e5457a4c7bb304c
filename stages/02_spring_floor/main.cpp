#include "02_spring_floor/exact.hpp"
#include "02_spring_floor/spring_floor.hpp"
#include "app/side_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo = side_demo<SpringFloor, SpringFloorExact>();
  demo.stage = {"02_spring_floor", "a ball that bounces on a floor that is a spring"};
  demo.title = "Stage 2: spring floor";
  demo.question = "A softer or a harder floor: on which of them does the ball come back higher?";
  demo.sliders = {"stiffness", "position"};
  demo.plots = {plot_column("velocity", "m/s", "v"),
                plot_energy_error("energy that the method made")};
  return play(argc, argv, demo);
}
