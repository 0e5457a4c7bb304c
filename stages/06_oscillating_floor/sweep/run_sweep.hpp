#pragma once
#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/sweep/bifurcation_picture.hpp"
#include "06_oscillating_floor/sweep/sweep.hpp"
#include "app/demo.hpp"
#include "run/interrupt.hpp"
#include "run/one_ball_run.hpp"
#include "run/output_file.hpp"

namespace bounce {

/// The rows of a sweep as a picture. A picture is of a run, so it takes one: at its first moment.
inline void save_bifurcation(const std::vector<SweepRow>& rows, const Sweep& sweep,
                             const std::string& unit, const Simulation& simulation,
                             const Options& options, const Demo& demo) {
  Demo picture = demo;
  picture.bare = true;
  const Range across{sweep.values.front(), sweep.values.back()};
  picture.picture = [&](const Playback&, const View&, Canvas& canvas) {
    draw_bifurcation(canvas, rows, across, sweep.name, unit);
  };
  Options at_once = options;
  at_once.duration = 0;
  save_picture(picture, simulation.clone(), at_once, options.screenshot);
}

/// `--sweep`: many bounces for each value of a parameter, as rows and as a picture.
inline std::optional<int> run_sweep(const Simulation& simulation, const Options& options,
                                    const Demo& demo) {
  const auto asked = options.of_stage.find("--sweep");
  if (asked == options.of_stage.end()) return std::nullopt;
  using Its = OneBallRun<OscillatingFloor, OscillatingFloorExact>;
  OscillatingFloor scene = run_as<Its>(simulation).scene();
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
  catch_interrupts();
  const auto write = [&](double value, const Bounce& bounce) {
    rows.push_back({value, bounce.phase, bounce.height});
    if (!csv) return;
    csv->write(to_text(value) + "," + to_text(bounce.phase) + "," + to_text(bounce.height) + "\n");
  };
  for (std::size_t i = 0; i < sweep.values.size() && !interrupted();) {  // else rows are kept
    std::vector<OscillatingFloor> scenes;                                // side by side
    for (std::size_t n = i; n < std::min(i + lanes, sweep.values.size()); ++n) {
      parameter.set(to_text(sweep.values[n]));
      scenes.push_back(scene);
    }
    for (const std::vector<Bounce>& bounces : settled_bounces(scenes, discarded, kept)) {
      for (const Bounce& bounce : bounces) write(sweep.values[i], bounce);
      ++i;
    }
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (csv) csv->finish();
  if (!options.screenshot.empty()) {
    save_bifurcation(rows, sweep, parameter.unit, simulation, options, demo);
  }
  std::cerr << demo.stage.name << ": sweep of " << sweep.name << " values=" << sweep.values.size()
            << " bounces_kept=" << rows.size() << " wall_s=" << to_rounded_text(wall.count())
            << "\n";
  return interrupted() ? exit_interrupted : exit_ok;
}

}  // namespace bounce
