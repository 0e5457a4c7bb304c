#include "app/demo.hpp"
#include "options.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"05_ball_collision", "balls that bounce off each other"};
  demo.title = "Stage 5: ball against ball";
  demo.question = "?";
  demo.sliders = {"scene", "gap"};
  demo.make = [] { return std::make_unique<BallsSimulation>(); };
  demo.options = ball_collision_options();
  demo.picture = [](const Player&, const View&, Canvas&) {};
  return play(argc, argv, demo);
}
