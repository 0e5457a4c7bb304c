#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/slider/tilt.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "app/space_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  const BallInSpace look{.landings = true, .look_at = {3.3, -0.6, 0}, .room = 3.2, .distance = 11};
  Demo demo = space_demo<TiltedPlane, TiltedPlaneExact>(look);
  demo.stage = {"07_tilted_plane", "a ball that bounces down a tilted plane"};
  demo.title = "Stage 7: tilted plane";
  demo.question =
      "Turn off the damping. How do the distances between the landings grow? And which tilt makes "
      "the beat faster?";
  demo.dials = {tilt_dial()};
  demo.sliders = {"damping", "stiffness"};
  demo.plots = {plot_column("velocity along x", "m/s", "vx"),
                plot_column("velocity along y (up)", "m/s", "vy")};
  return play(argc, argv, demo);
}
