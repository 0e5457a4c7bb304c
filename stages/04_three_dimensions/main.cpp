#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "app/space_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo = space_demo<ThreeDimensions, ThreeDimensionsExact>();
  demo.stage = {"04_three_dimensions", "a ball thrown over a floor in three dimensions"};
  demo.title = "Stage 4: three dimensions";
  demo.question =
      "Press T and look from straight above. Which path does the ball draw there, and how fast "
      "does it go?";
  demo.sliders = {"velocity", "damping"};
  demo.plots = {plot_column("velocity along y (up)", "m/s", "vy"),
                plot_column("velocity along x", "m/s", "vx")};
  return play(argc, argv, demo);
}
