#include "app/demo.hpp"

#include <iostream>

#include "run/output_file.hpp"

namespace bounce {
namespace {

/// What is left to do without a display: a run, a trace, and a picture where that can be drawn.
int run_unseen(const Demo& demo, std::unique_ptr<Simulation> simulation, Options options) {
  options.csv = demo.stage.name + ".csv";
  const std::string picture = demo.stage.name + ".png";
  if (has_window()) save_picture(demo, simulation->clone(), options, picture);
  const int code = run_headless(demo.stage, *simulation, options);
  std::cerr << demo.stage.name << ": the trace is in " << options.csv
            << (has_window() ? ", the picture in " + picture : "") << "\n";
  return code;
}

}  // namespace

int play(int argc, const char* const* argv, const Demo& demo) {
  std::unique_ptr<Simulation> simulation = demo.make();
  const Simulation& shown = *simulation;  // for the advice when something fails
  std::unique_ptr<Simulation> spare;
  return guarded(demo.stage, shown, [&]() -> int {
    Options options;
    if (!parse_command_line(argc, argv, demo.stage, *simulation, options, demo.options)) {
      return exit_ok;
    }
    if (options.headless) {
      if (!options.screenshot.empty()) {
        save_picture(demo, simulation->clone(), options, options.screenshot);
      }
      if (!options.record.empty()) record_clip(demo, simulation->clone(), options, options.record);
      const bool pictures_only = options.csv.empty() && options.save.empty() &&
                                 !(options.screenshot.empty() && options.record.empty());
      return pictures_only ? exit_ok : run_headless(demo.stage, *simulation, options);
    }
    if (show_window(demo, simulation->clone(), options)) return exit_ok;
    return run_unseen(demo, simulation->clone(), options);
  });
}

}  // namespace bounce
