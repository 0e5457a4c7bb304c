#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "app/side_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo = side_demo<Damping, DampingExact>();
  demo.stage = {"03_damping", "a ball on a floor with spring and damper"};
  demo.title = "Stage 3: damping";
  demo.question =
      "How much damping lets the ball come back to half its height? And how much makes it stay "
      "down?";
  demo.sliders = {"damping", "stiffness", "contact"};
  demo.plots = {plot_column("velocity", "m/s", "v"), plot_lost_energy("energy lost to the damper")};
  return play(argc, argv, demo);
}
