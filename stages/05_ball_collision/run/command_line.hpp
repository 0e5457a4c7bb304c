#pragma once
#include <vector>

#include "05_ball_collision/files/balls_file.hpp"
#include "05_ball_collision/files/lammps_export.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "many_balls/lammps_import.hpp"

namespace bounce {

/// What this stage's command line has besides that of all stages.
inline std::vector<StageOption> ball_collision_options() {
  const auto balls = [](std::unique_ptr<Simulation>& simulation, const std::string& path) {
    run_as<BallsRun>(*simulation).world().use_balls(BallsFile(path).read(), path);
  };
  const auto threads = [](std::unique_ptr<Simulation>& simulation, const std::string& text) {
    const double number = option_number("--threads", text, {1, 1024}, "", true);
    run_as<BallsRun>(*simulation).world().threads = static_cast<int>(number);
  };
  const auto import = [](Simulation& simulation, const std::string& path) {
    const std::string option = "--import-lammps";
    continue_from(run_as<BallsRun>(simulation), many::read_lammps_dump(option, path),
                  option + " " + path);
  };
  return {{"--balls",
           "FILE",
           "balls from a CSV file in place of a scene: mass,radius,x,y,z,vx,vy,vz",
           with_files(balls),
           {"scene", "count", "gap"}},
          {"--threads",
           "N",
           "threads that may be used (default 1); results do not depend on it",
           threads,
           {}},
          {"--import-lammps",
           "FILE",
           "go on from the last frame of a LAMMPS dump",
           {},
           {},
           with_files(import)},
          {"--export-lammps", "DIR", "write the run as files for LAMMPS, and end"}};
}

}  // namespace bounce
