#include <chrono>
#include <iostream>
#include <numbers>
#include <optional>

#include "app/demo.hpp"
#include "app/palette.hpp"
#include "app/side_view.hpp"
#include "bifurcation_picture.hpp"
#include "exact.hpp"
#include "oscillating_floor.hpp"
#include "run/output_file.hpp"
#include "run/scene_simulation.hpp"
#include "steady_hand.hpp"
#include "sweep.hpp"

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

/// `--sweep`: many bounces for each value of a parameter, as rows and as a picture.
static std::optional<int> sweep(Simulation& simulation, const Options& options, const Demo& demo) {
  const auto asked = options.of_stage.find("--sweep");
  if (asked == options.of_stage.end()) return std::nullopt;
  OscillatingFloor scene = scene_of(simulation);
  const Sweep sweep = read_sweep(asked->second, scene);
  if (options.csv.empty() && options.screenshot.empty()) {
    throw BadInput("--sweep needs a place for its result: give --csv FILE (or -), or --screenshot");
  }
  constexpr int discarded = 300, kept = 100;  // bounces
  const std::vector<Parameter> parameters = scene.parameters();
  const Parameter& parameter = find_parameter(parameters, sweep.name);

  std::optional<OutputFile> csv;
  if (!options.csv.empty()) csv.emplace("--csv", options.csv);
  if (csv) csv->write(sweep.name + ",phase,height\n");
  const auto begin = std::chrono::steady_clock::now();
  std::vector<SweepRow> rows;
  for (const double value : sweep.values) {
    parameter.set(to_text(value));
    for (const Bounce& bounce : settled_bounces(scene, discarded, kept)) {
      rows.push_back({value, bounce.phase, bounce.height});
      if (!csv) continue;
      csv->write(to_text(value) + "," + to_text(bounce.phase) + "," + to_text(bounce.height) +
                 "\n");
    }
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (csv) csv->finish();
  if (!options.screenshot.empty()) {
    Demo picture = demo;
    picture.bare = true;
    const Range across{sweep.values.front(), sweep.values.back()};
    picture.picture = [&](const Player&, const View&, Canvas& canvas) {
      draw_bifurcation(canvas, rows, across, sweep.name, parameter.unit);
    };
    Options at_once = options;
    at_once.duration = 0;
    save_picture(picture, simulation.clone(), at_once, options.screenshot);
  }
  std::cerr << demo.stage.name << ": sweep of " << sweep.name << " values=" << sweep.values.size()
            << " bounces_kept=" << rows.size() << " wall_s=" << to_rounded_text(wall.count())
            << "\n";
  return exit_ok;
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
    return sweep(simulation, options, demo);
  };
  return play(argc, argv, demo);
}
