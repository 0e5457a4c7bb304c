#include "many_balls/lammps_export.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "physics/neighbour_grid.hpp"
#include "physics/text.hpp"

namespace bounce::many {
namespace {

/// The walls in the order of the axes: at 0, and at `far` where that is positive.
struct Wall {
  const char* name;
  int axis;
  bool there;
  double far;
};

std::array<Wall, 3> walls_of(const Laws& laws) {
  return {{{"x", 0, laws.tray[0] > 0, laws.tray[0]},
           {"y", 1, laws.floor, 0},
           {"z", 2, laws.tray[1] > 0, laws.tray[1]}}};
}

bool centres_coincide(const LammpsTask& task) {
  NeighbourGrid grid;
  for (const auto& [i, j] : grid.pairs(task.balls.position, task.radius)) {
    if (task.balls.position.col(i) == task.balls.position.col(j)) return true;
  }
  return false;
}

std::string range_of(const LammpsTask& task, int axis, const char* name) {
  const auto row = task.balls.position.row(axis);
  const double r = task.radius.maxCoeff();
  const std::string letter = name;
  return to_text(row.minCoeff() - r) + " " + to_text(row.maxCoeff() + r) + " " + letter + "lo " +
         letter + "hi\n";
}

}  // namespace

std::string lammps_cannot(const LammpsTask& task) {
  const Laws& laws = task.laws;
  const bool damped = laws.between_balls.damping > 0 || laws.surfaces.damping > 0;
  if (damped && laws.between_balls.law == ContactLaw::push_only) {
    return "contact=push-only with damping is a law that its gran/hooke does not have: take "
           "contact=may-pull";
  }
  if (damped && task.mass.minCoeff() != task.mass.maxCoeff()) {
    return "its damping grows with the mass and ours does not, so that with damping all balls must "
           "have the same mass";
  }
  for (const Wall& wall : walls_of(laws)) {
    if (!wall.there) continue;
    const auto row = task.balls.position.row(wall.axis);
    if (row.minCoeff() < 0 || (wall.far > 0 && row.maxCoeff() > wall.far)) {
      return std::string(
                 "its walls push away from both of their sides, and a ball's centre is "
                 "beyond the one that ends ") +
             wall.name;
    }
    if (wall.far > 0 && wall.far < 2 * task.radius.maxCoeff()) {
      return "a ball there touches one wall of a pair only, and this tray is narrower than a ball";
    }
  }
  if (centres_coincide(task)) return "two balls have the same centre, and it divides by 0 there";
  return "";
}

void write_lammps_data(const LammpsTask& task, const Write& write) {
  std::string text = "balls from Bounce\n\n" + std::to_string(task.mass.size()) +
                     " atoms\n1 atom types\n" + range_of(task, 0, "x") + range_of(task, 1, "y") +
                     range_of(task, 2, "z") + "\nAtoms # sphere\n\n";
  const auto pass_on = [&](std::size_t from) {
    if (text.size() < from) return;
    write(text);
    text.clear();
  };
  const auto add = [&text](const auto& vector) {
    for (int axis = 0; axis < 3; ++axis) (text += ' ') += to_text(vector[axis]);
  };
  for (Eigen::Index i = 0; i < task.mass.size(); ++i) {
    const double r = task.radius[i];
    const double density = task.mass[i] / (4.0 / 3 * std::numbers::pi * r * r * r);
    text += std::to_string(i + 1) + " 1 " + to_text(2 * r) + " " + to_text(density);
    add(task.balls.position.col(i));
    text += "\n";
    pass_on(1 << 16);
  }
  text += "\nVelocities\n\n";
  for (Eigen::Index i = 0; i < task.mass.size(); ++i) {
    text += std::to_string(i + 1);
    add(task.balls.velocity.col(i));
    text += " 0 0 0\n";  // no spin
    pass_on(1 << 16);
  }
  pass_on(0);
}

std::string lammps_script(const LammpsTask& task) {
  const Laws& laws = task.laws;
  const double mass = task.mass.maxCoeff();  // where there is damping, they are all equal
  std::string text =
      "# Written by Bounce: balls as springs and dampers, y upwards.\n"
      "units si\n"
      "atom_style sphere\n"
      "boundary s s s              # the box follows the balls\n"
      "comm_modify vel yes         # the dampers need the velocities of the neighbours' balls\n"
      "read_data balls.data\n"
      "neighbor " +
      to_text(0.2 * task.radius.maxCoeff()) +
      " bin\n"
      "neigh_modify every 1 delay 0 check yes\n"
      "pair_style gran/hooke " +
      to_text(laws.between_balls.stiffness) + " 0 " +
      to_text(2 * laws.between_balls.damping / mass) +
      " 0 0 0  # k, and gamma = 2c/m\n"
      "pair_coeff * *\n";
  if (laws.gravity > 0) {
    text += "fix weight all gravity " + to_text(laws.gravity) + " vector 0 -1 0\n";
  }
  for (const Wall& wall : walls_of(laws)) {
    if (!wall.there) continue;
    text += std::string("fix wall_") + wall.name + " all wall/gran hooke " +
            to_text(laws.surfaces.stiffness) + " 0 " + to_text(laws.surfaces.damping / mass) +
            " 0 0 0 " + wall.name + "plane 0 " + (wall.far > 0 ? to_text(wall.far) : "NULL") +
            "  # k, and gamma = c/m\n";
  }
  return text + "fix move all nve            # velocity Verlet\ntimestep " + to_text(task.dt) +
         "\nreset_timestep " + std::to_string(task.first_step) + "\nthermo " +
         std::to_string(std::max(1LL, task.steps / 10)) + "\nrun " + std::to_string(task.steps) +
         "\nwrite_dump all custom balls.dump id radius mass x y z vx vy vz fx fy fz &\n"
         "  modify sort id format float %.17g\n";
}

}  // namespace bounce::many
