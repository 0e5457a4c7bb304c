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
  const std::unique_ptr<Simulation> simulation = demo.make();
  return guarded(demo.stage, *simulation, [&]() -> int {
    Options options;
    if (!parse_command_line(argc, argv, demo.stage, *simulation, options, demo.options)) {
      return exit_ok;
    }
    if (demo.other_work) {
      if (const std::optional<int> code = demo.other_work(*simulation, options)) return *code;
    }
    if (!options.headless) {
      if (show_window(demo, simulation->clone(), options)) return exit_ok;
      return run_unseen(demo, simulation->clone(), options);
    }
    if (!options.csv.empty()) OutputFile::check("--csv", options.csv);
    if (!options.save.empty()) OutputFile::check("--save", options.save);
    if (!options.screenshot.empty()) {
      save_picture(demo, simulation->clone(), options, options.screenshot);
    }
    if (!options.record.empty()) record_clip(demo, simulation->clone(), options, options.record);
    return run_headless(demo.stage, *simulation, options);
  });
}

}  // namespace bounce
