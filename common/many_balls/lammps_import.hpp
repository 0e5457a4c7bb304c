#pragma once
#include <Eigen/Core>
#include <string>

#include "physics/state.hpp"

namespace bounce::many {

/// The last frame of a LAMMPS dump.
struct LammpsFrame {
  long long step = 0;
  State<Eigen::Matrix3Xd> balls;  // m, m/s; in the order of the ids
  Eigen::VectorXd mass;           // kg; empty when the dump has no such column
  Eigen::VectorXd radius;         // m; the same
  Eigen::Matrix3Xd force;         // N; no columns when the dump has none
};

/// Reads `dump custom` text: the columns id x y z vx vy vz, and where they are there mass, radius,
/// fx fy fz, in any order; others are passed over. Rows may come in any order, with the ids 1 to N.
/// Of several frames the last one counts. Throws BadInput with the line and the reason; `option` is
/// what the user gave the path to.
LammpsFrame read_lammps_dump(const std::string& option, const std::string& path);

}  // namespace bounce::many
