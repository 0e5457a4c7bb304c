#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/picture/survey.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/run_sweep.hpp"
#include "app/side_view.hpp"

using namespace bounce;

int main(int argc, char** argv) {
  Demo demo = side_demo<OscillatingFloor, OscillatingFloorExact>({.lowest = -0.3, .highest = 0.9});
  demo.stage = {"06_oscillating_floor", "a ball on a floor that moves up and down"};
  demo.title = "Stage 6: oscillating floor";
  demo.question =
      "Raise the amplitude slowly. When do the bounces stop being all alike? And what comes after "
      "that?";
  demo.sliders = {"amplitude", "angular_frequency", "floor_law"};
  demo.set = set_without_jump;
  demo.plots = {plot_column("velocity", "m/s", "v"),
                plot_lost_energy("energy lost to the damper, this bounce")};
  if constexpr (has_picture) demo.survey = amplitude_survey();
  demo.options = {{"--sweep", "NAME=FROM,TO,N",
                   "N values of a parameter: for each, 100 bounces after 300, to --csv or "
                   "--screenshot"}};
  demo.other_work = with_files([&demo](Simulation& simulation, const Options& options) {
    return run_sweep(simulation, options, demo);
  });
  return play(argc, argv, demo);
}
