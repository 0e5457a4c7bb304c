#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>

#include "many_balls/pass.hpp"
#include "physics/state.hpp"

namespace bounce::many {

/// A run of many balls as it is handed to LAMMPS.
struct LammpsTask {
  Laws laws;
  const Eigen::VectorXd& mass;           // kg
  const Eigen::VectorXd& radius;         // m
  const State<Eigen::Matrix3Xd>& balls;  // m, m/s
  double dt;                             // s
  long long first_step;                  // at which the run stands
  long long steps;                       // to take
};

/// Why LAMMPS would compute something else, as the end of a sentence; empty when it would not.
std::string lammps_cannot(const LammpsTask& task);

/// Where the text of a file goes, piece by piece.
using Write = std::function<void(std::string_view)>;

/// The balls, as `read_data` wants them for `atom_style sphere`: diameter and density for radius
/// and mass.
void write_lammps_data(const LammpsTask& task, const Write& write);

/// The input script: the same law, walls and time step, and velocity Verlet, which LAMMPS calls
/// `fix nve`. It reads `balls.data`, and at the end writes all balls to `balls.dump`, in decimals
/// that read back to the same bits.
///
/// LAMMPS multiplies a damping gamma by the reduced mass, m/2 between two balls and m at a wall
/// (its documentation of pair_style gran/hooke): c = gamma m/2 makes gamma = 2c/m and c/m.
std::string lammps_script(const LammpsTask& task);

}  // namespace bounce::many
