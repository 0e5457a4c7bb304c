#pragma once
#include <optional>
#include <string>

#include "many_balls/crowds.hpp"

namespace bounce::test {

/// What LAMMPS made of a crowd.
struct LammpsRun {
  State<Eigen::Matrix3Xd> balls;  // m, m/s
  double seconds;                 // of its time loop, on the clock on the wall
};

/// Runs `lmp` (Debian: lammps) on the same law: pair gran/hooke, floor and walls wall/gran, fix
/// nve, on one processor. `start` and the result are in our axes; LAMMPS has z up. All balls must
/// have the radius and the mass of the first. Throws std::runtime_error when it does not end well;
/// nothing where it is not installed.
std::optional<LammpsRun> run_lammps(const Crowd& start, long steps, double dt);

}  // namespace bounce::test
