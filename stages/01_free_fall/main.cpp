#include "01_free_fall/exact.hpp"
#include "01_free_fall/free_fall.hpp"
#include "app/side_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  // Drawn with a radius, which its law does not have; and high enough to fall for a second.
  const BallOnALine look{
      .radius = 0.12, .floor = false, .strobe = true, .lowest = -1.0, .highest = 5.3};
  Demo demo = side_demo<FreeFall, FreeFallExact>(look);
  demo.stage = {"01_free_fall", "a ball falls, step by step and by formula"};
  demo.title = "Stage 1: free fall";
  demo.question =
      "Make dt a hundred times larger. Where does the ball of the loop end up beside the one of "
      "the formula?";
  demo.sliders = {"mass", "gravity"};
  demo.plots = {plot_column("velocity", "m/s", "v"), plot_error("position minus exact", "m", "y")};
  return play(argc, argv, demo);
}
