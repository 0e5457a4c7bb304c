#pragma once
#include <algorithm>
#include <iostream>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "app/demo.hpp"
#include "app/diagram.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "run/interrupt.hpp"
#include "run/output_file.hpp"

namespace bounce {

/// `--sweep amplitude=FROM,TO,N`: a parameter of a scene that takes N values from FROM to TO.
struct Sweep {
  Parameter parameter;
  std::vector<double> values;
  std::vector<std::vector<Bounce>> bounces;  // for each value, as far as it has come
};

/// Reads and checks it, against what `scene` allows. Throws BadInput.
inline Sweep read_sweep(const std::string& text, OscillatingFloor& scene) {
  const auto refuse = [&text](const std::string& why) {
    throw BadInput("--sweep '" + text + "' is not allowed: " + why +
                   "; it must be NAME=FROM,TO,N, such as amplitude=0.05,0.1,400");
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse("it names no parameter");
  const Parameter parameter = find_parameter(scene.parameters(), text.substr(0, equals));
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
  Sweep sweep{parameter, {}, {}};
  for (double i = 0; i < *count; ++i) {
    sweep.values.push_back(from + (to - from) * i / (*count - 1));
  }
  return sweep;
}

/// One diagram: `value` of every bounce against the parameter, a pixel each.
inline void draw_diagram(Canvas& canvas, const Diagram& diagram, const Sweep& sweep,
                         double Bounce::*value, const std::string& title) {
  diagram.draw(canvas, title, 10, 5, "", true);
  std::set<std::pair<int, int>> drawn;  // many bounces, few places: one dot for each
  for (std::size_t i = 0; i < sweep.bounces.size(); ++i) {
    for (const Bounce& bounce : sweep.bounces[i]) {
      const Point dot = diagram.at(sweep.values[i], bounce.*value);
      const std::pair<int, int> pixel(static_cast<int>(dot.x), static_cast<int>(dot.y));
      if (!drawn.insert(pixel).second) continue;
      const auto x = static_cast<float>(pixel.first), y = static_cast<float>(pixel.second);
      draw_rect(canvas, {x, y, 1.5f, 1.5f}, palette::motion.faded(0.6));
    }
  }
}

/// Where bounces settle, against the parameter: their height, and the floor's angle at the impact.
inline void draw_bifurcation(Canvas& canvas, const Sweep& sweep) {
  double highest = 0;
  for (const std::vector<Bounce>& bounces : sweep.bounces) {
    for (const Bounce& bounce : bounces) highest = std::max(highest, bounce.height);
  }
  const std::vector<double> round = ticks(0, highest, 5);
  const double top = round.size() > 1 ? round.back() + round[1] : 1;
  const float width = layout::width - 120;
  const Range across{sweep.values.front(), sweep.values.back()};
  const Diagram heights{{80, 60, width, 370}, across, {0, top}};
  const Diagram phases{{80, 494, width, 160}, across, {0, 2 * std::numbers::pi}};
  draw_diagram(canvas, heights, sweep, &Bounce::height, "height of the bounce, m");
  draw_diagram(canvas, phases, sweep, &Bounce::phase,
               "angle of the floor's swing at the impact, rad");
  canvas.text({80 + width, 686}, sweep.parameter.name + ", " + sweep.parameter.unit, palette::ink,
              Align::right, TextSize::title);
}

/// A picture is of a run, so it takes one: at its first moment.
inline void save_bifurcation(const Sweep& sweep, const Simulation& simulation,
                             const Options& options, const Demo& demo) {
  Demo picture = demo;
  picture.bare = true;
  picture.picture = [&](const Playback&, const View&, Canvas& canvas) {
    draw_bifurcation(canvas, sweep);
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
  OscillatingFloor scene = run_as<OscillatingFloorRun>(simulation).scene();
  Sweep sweep = read_sweep(asked->second, scene);
  if (options.csv.empty() && options.screenshot.empty()) {
    throw BadInput("--sweep needs a place for its result: give --csv FILE (or -), or --screenshot");
  }
  constexpr int discarded = 300, kept = 100;  // bounces

  std::optional<OutputFile> csv;
  if (!options.csv.empty()) csv.emplace("--csv", options.csv);
  if (csv) csv->write(sweep.parameter.name + ",phase,height\n");
  const double begin = Playback::wall_clock();
  std::size_t all = 0;
  catch_interrupts();
  while (sweep.bounces.size() < sweep.values.size() && !interrupted()) {  // else some are kept
    std::vector<OscillatingFloor> scenes;                                 // side by side
    for (const double value : std::span(sweep.values).subspan(sweep.bounces.size())) {
      if (scenes.size() == lanes) break;
      sweep.parameter.set(to_text(value));
      scenes.push_back(scene);
    }
    for (std::vector<Bounce>& bounces : settled_bounces(scenes, discarded, kept)) {
      const std::string value = to_text(sweep.values[sweep.bounces.size()]);
      for (const Bounce& bounce : bounces) {
        if (!csv) break;
        csv->write(value + "," + to_text(bounce.phase) + "," + to_text(bounce.height) + "\n");
      }
      all += bounces.size();
      sweep.bounces.push_back(std::move(bounces));
    }
  }
  const double wall = Playback::wall_clock() - begin;
  if (csv) csv->finish();
  if (!options.screenshot.empty()) save_bifurcation(sweep, simulation, options, demo);
  std::cerr << demo.stage.name << ": sweep of " << sweep.parameter.name
            << " values=" << sweep.values.size() << " bounces_kept=" << all
            << " wall_s=" << to_rounded_text(wall) << "\n";
  return interrupted() ? exit_interrupted : exit_ok;
}

}  // namespace bounce
