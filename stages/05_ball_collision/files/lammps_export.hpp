#pragma once
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include "05_ball_collision/run/balls_world.hpp"
#include "many_balls/lammps_export.hpp"
#include "run/headless.hpp"
#include "run/output_file.hpp"

namespace bounce {

/// A time in steps, for a program that knows only whole ones.
inline long long whole_steps(double time, double dt, const std::string& what) {
  const double steps = time / dt;
  if (std::abs(steps - std::round(steps)) < 1e-6 && steps < 1e15) return std::llround(steps);
  throw BadInput(what + " is " + to_rounded_text(steps, 10) + " steps of " + to_text(dt) +
                 " s, and LAMMPS takes whole ones: choose a --duration or --dt that fits");
}

inline void write_lammps_file(const OutputFolder& folder, const std::string& name,
                              const std::function<void(const many::Write&)>& content) {
  OutputFile file("--export-lammps", folder.file(name));
  content([&file](std::string_view text) { file.write(text); });
  file.finish();
}

/// `--export-lammps DIR`: what is left of the run, as files for LAMMPS. Nothing, when it was not
/// asked for.
inline std::optional<int> export_lammps(const StageName& stage, Simulation& any,
                                        const Options& options) {
  const auto asked = options.of_stage.find("--export-lammps");
  if (asked == options.of_stage.end()) return std::nullopt;
  BallsRun& simulation = run_as<BallsRun>(any);
  const std::string given = "--export-lammps '" + asked->second + "' is not allowed: ";
  if (simulation.method() != methods::velocity_verlet) {
    throw BadInput(given + "LAMMPS moves balls with velocity Verlet, not with " +
                   name_of(simulation.method()) + ": it must be --method velocity-verlet");
  }
  const double dt = simulation.dt();
  const many::LammpsTask task{
      simulation.world().laws(),
      simulation.scene().mass,
      simulation.scene().radius,
      simulation.state(),
      dt,
      whole_steps(simulation.time(), dt, "the time at which the run stands"),
      whole_steps(options.duration - simulation.time(), dt, "what is left of --duration")};
  if (const std::string why = many::lammps_cannot(task); !why.empty()) {
    throw BadInput(given + "LAMMPS would compute something else: " + why);
  }
  OutputFolder folder("--export-lammps", asked->second);
  write_lammps_file(folder, "balls.data",
                    [&](const many::Write& write) { many::write_lammps_data(task, write); });
  write_lammps_file(folder, "in.bounce",
                    [&](const many::Write& write) { write(many::lammps_script(task)); });
  BallsRun fresh;
  const std::string back = command_for(stage, simulation, fresh);
  write_lammps_file(folder, "README", [&](const many::Write& write) {
    write(
        "Run it here, on 4 processes or as many as you have: mpirun -np 4 lmp -in in.bounce\n"
        "It takes " +
        std::to_string(task.steps) + " steps of " + to_text(dt) +
        " s, and writes the balls at the end to balls.dump.\n"
        "Back: " +
        back + " --import-lammps balls.dump --duration LATER\n");
  });
  folder.finish();
  std::cerr << stage.name << ": " << simulation.balls() << " balls and " << task.steps
            << " steps for LAMMPS are in " << asked->second << "; see its README\n";
  return exit_ok;
}

}  // namespace bounce
