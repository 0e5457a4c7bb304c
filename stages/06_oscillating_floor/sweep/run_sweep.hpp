#pragma once
#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "06_oscillating_floor/sweep/bifurcation_picture.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "app/demo.hpp"
#include "run/interrupt.hpp"
#include "run/one_ball_run.hpp"
#include "run/output_file.hpp"

namespace bounce {

/// `--sweep amplitude=FROM,TO,N`: a parameter that takes N values from FROM to TO.
struct Sweep {
  std::string name;
  std::vector<double> values;
};

/// Reads and checks it, against what `scene` allows. Throws BadInput.
inline Sweep read_sweep(const std::string& text, OscillatingFloor scene) {
  const auto refuse = [&text](const std::string& why) {
    throw BadInput("--sweep '" + text + "' is not allowed: " + why +
                   "; it must be NAME=FROM,TO,N, such as amplitude=0.05,0.1,400");
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse("it names no parameter");
  const std::vector<Parameter> parameters = scene.parameters();
  const Parameter& parameter = find_parameter(parameters, text.substr(0, equals));
  if (!std::holds_alternative<double*>(parameter.value)) {
    refuse("'" + parameter.name + "' is no number");
  }
  const std::vector<std::string> words = split(text.substr(equals + 1));
  if (words.size() != 3) refuse("it needs three numbers");
  parameter.set(words[0]);  // these throw for what the parameter does not allow
  parameter.set(words[1]);
  const double from = parse_number(words[0]).value(), to = parse_number(words[1]).value();
  const std::optional<double> count = parse_number_in(words[2], {2, 1e6}, true);
  if (!count) refuse("N must be a whole number from 2 to 1e6");
  if (!(from < to)) refuse("FROM must be smaller than TO");
  Sweep sweep{parameter.name, {}};
  for (double i = 0; i < *count; ++i) {
    sweep.values.push_back(from + (to - from) * i / (*count - 1));
  }
  return sweep;
}

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
