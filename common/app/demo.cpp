#include "app/demo.hpp"

#include <filesystem>
#include <utility>

#include "run/file_name.hpp"
#include "run/output_file.hpp"

namespace bounce {
namespace {

/// Here, or in the folder for temporary files where nothing may be written here.
std::string place_for(const std::string& file) {
  try {
    OutputFile::check("", file);
    return file;
  } catch (const BadInput&) {
    return name_of(std::filesystem::temp_directory_path() / file);
  }
}

/// What is left to do without a display: a run, a trace, and a picture where that can be drawn.
int run_unseen(const Demo& demo, std::unique_ptr<Simulation> simulation, Options options) {
  options.csv = place_for(demo.stage.name + ".csv");
  const std::string picture = place_for(demo.stage.name + ".png");
  if (has_window()) save_picture(demo, simulation->clone(), options, picture);
  const int code = run_headless(demo.stage, *simulation, options);
  std::cerr << demo.stage.name << ": the trace is in " << options.csv
            << (has_window() ? ", the picture in " + picture : "") << "\n";
  return code;
}

}  // namespace

/// Two outputs in one file would leave only one of them.
static void refuse_same_file(const Options& options) {
  const std::pair<const char*, const std::string*> outputs[] = {
      {"--csv", &options.csv},
      {"--save", &options.save},
      {"--screenshot", &options.screenshot},
      {"--record", &options.record}};
  for (const auto& a : outputs) {
    for (const auto& b : outputs) {
      if (&a >= &b || a.second->empty() || b.second->empty() || *a.second == "-" ||
          *a.second == "/dev/null")
        continue;
      const auto place = [](const std::string& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path_of(path)));
      };
      if (place(*a.second) != place(*b.second)) continue;
      throw BadInput(std::string(a.first) + " and " + b.first + " name the same file '" +
                     *a.second + "': each must have one of its own");
    }
  }
}

static int end(const Demo& demo, int code) {
  if (code == exit_ok && demo.at_end) demo.at_end();
  return code;
}

int play_demo(int argc, const char* const* argv, const Demo& demo) {
  std::unique_ptr<Simulation> simulation = demo.make();
  return guarded(demo.stage, *simulation, [&]() -> int {
    Options options;
    if (!parse_command_line(argc, argv, demo.stage, simulation, options, demo.options)) {
      return exit_ok;
    }
    refuse_same_file(options);
    if (demo.other_work) {
      if (const std::optional<int> code = demo.other_work(*simulation, options)) return *code;
    }
    if (!options.headless) {
      const bool shown = show_window(demo, simulation->clone(), options);
      return end(demo, shown ? exit_ok : run_unseen(demo, simulation->clone(), options));
    }
    if (!options.csv.empty()) OutputFile::check("--csv", options.csv);
    if (!options.save.empty()) OutputFile::check("--save", options.save);
    if (!options.screenshot.empty()) {
      save_picture(demo, simulation->clone(), options, options.screenshot);
    }
    if (!options.record.empty()) record_clip(demo, simulation->clone(), options, options.record);
    return end(demo, run_headless(demo.stage, *simulation, options));
  });
}

}  // namespace bounce
