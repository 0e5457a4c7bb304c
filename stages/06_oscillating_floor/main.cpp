#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/run_sweep.hpp"
#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"
#include "run/scene_simulation.hpp"

using namespace bounce;

using Run = SceneSimulation<OscillatingFloor, OscillatingFloorExact>;

static const OscillatingFloor& scene_of(const Simulation& simulation) {
  return static_cast<const Run&>(simulation).scene();
}

static BallOnALine ball(const Player& player) {
  const OscillatingFloor scene = scene_of(player.simulation());
  const auto forces = [scene](double t, const State<double>& state) {
    return ForcesOnALine{-scene.mass * scene.gravity,
                         scene.stiffness * scene.compression(t, state.position),
                         scene.damper_force(t, state)};
  };
  BallOnALine look{.radius = scene.radius, .forces = forces};
  look.floor_height = [scene](double t) { return scene.floor_height(t); };
  look.column = 1;  // the trace's values: floor, y, v
  look.lowest = -0.3;
  look.highest = 0.9;
  return look;
}

/// A slider moves. Amplitude and frequency take the phase along, so that the floor does not jump.
static void set_without_jump(Simulation& simulation, const Parameter& parameter,
                             const std::string& text) {
  const OscillatingFloor before = scene_of(simulation);
  parameter.set(text);
  if (parameter.name != "amplitude" && parameter.name != "angular_frequency") return;
  const double phase = phase_without_jump(before, scene_of(simulation), simulation.time());
  find_parameter(simulation.parameters(), "phase").set(to_text(phase));
}

int main(int argc, char** argv) {
  Demo demo;
  demo.stage = {"06_oscillating_floor", "a ball on a floor that moves up and down"};
  demo.title = "Stage 6: oscillating floor";
  demo.question =
      "Raise the amplitude slowly. When do the bounces stop being all alike? And what comes after "
      "that?";
  demo.sliders = {"amplitude", "angular_frequency", "floor_law"};
  demo.make = [] { return std::make_unique<Run>(); };
  use_side_view(demo, ball);
  demo.set = set_without_jump;
  demo.plots = {
      {"velocity", "m/s", palette::motion, [](const TracePoint& point) { return point.values[2]; },
       [](const TracePoint& point) { return point.exact[2]; }},
      {"energy lost to the damper, this bounce",
       "J",
       palette::damper,
       [](const TracePoint& point) { return point.lost; },
       {}}};
  demo.options = {{"--sweep", "NAME=FROM,TO,N",
                   "N values of a parameter: for each, 100 bounces after 300, to --csv or "
                   "--screenshot"}};
  demo.other_work = [&demo](Simulation& simulation, const Options& options) {
    return run_sweep(scene_of(simulation), simulation, options, demo);
  };
  return play(argc, argv, demo);
}
