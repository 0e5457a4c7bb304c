#include "many_balls/lammps.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "temporary_folder.hpp"

namespace bounce::test {
namespace {

namespace fs = std::filesystem;

std::string exact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// Balls in LAMMPS's format: id type diameter density x y z, and velocities with three for the
/// spin.
void write_data(const Crowd& start, const fs::path& file) {
  const Eigen::Index count = start.scene.mass.size();
  const double r = start.scene.radius[0];
  const double density = start.scene.mass[0] / (4.0 / 3 * std::numbers::pi * r * r * r);
  std::ofstream out(file);
  out << "from bounce\n\n" << count << " atoms\n1 atom types\n";
  out << exact(-1) << " " << exact(start.scene.tray[0] + 1) << " xlo xhi\n";
  out << exact(-1) << " " << exact(start.scene.tray[1] + 1) << " ylo yhi\n";
  out << exact(-1) << " " << exact(start.balls.position.row(1).maxCoeff() + 1) << " zlo zhi\n";
  out << "\nAtoms\n\n";
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto p = start.balls.position.col(i);
    out << i + 1 << " 1 " << exact(2 * r) << " " << exact(density) << " " << exact(p.x()) << " "
        << exact(p.z()) << " " << exact(p.y()) << "\n";
  }
  out << "\nVelocities\n\n";
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto v = start.balls.velocity.col(i);
    out << i + 1 << " " << exact(v.x()) << " " << exact(v.z()) << " " << exact(v.y()) << " 0 0 0\n";
  }
}

/// LAMMPS multiplies the damping by the reduced mass: m/2 between two balls, m at a wall.
void write_input(const Crowd& start, long steps, double dt, const fs::path& file) {
  const BallCollision& scene = start.scene;
  const double m = scene.mass[0];
  std::ofstream out(file);
  const auto wall = [&](const std::string& name, const std::string& where) {
    out << "fix " << name << " all wall/gran hooke " << exact(scene.floor_stiffness) << " 0 "
        << exact(scene.floor_damping / m) << " 0 0 0 " << where << "\n";
  };
  out << "units si\natom_style sphere\nboundary f f f\ncomm_modify vel yes\n"
      << "read_data balls.data\n"
      << "neighbor 0.01 bin\nneigh_modify every 1 delay 0 check yes\n"
      << "pair_style gran/hooke " << exact(scene.stiffness) << " 0 " << exact(2 * scene.damping / m)
      << " 0 0 0\npair_coeff * *\n"
      << "fix weight all gravity " << exact(scene.gravity) << " vector 0 0 -1\n";
  if (scene.floor) wall("floor", "zplane 0 NULL");
  if (scene.tray[0] > 0) wall("wall_x", "xplane 0 " + exact(scene.tray[0]));
  if (scene.tray[1] > 0) wall("wall_y", "yplane 0 " + exact(scene.tray[1]));
  out << "fix move all nve\ntimestep " << exact(dt) << "\nthermo 1000000\nrun " << steps << "\n"
      << "write_dump all custom balls.dump id x y z vx vy vz modify sort id format float %.17g\n";
}

double loop_seconds(const std::string& log) {
  const std::string before = "Loop time of ";
  const std::size_t at = log.find(before);
  if (at == std::string::npos) throw std::runtime_error("lmp did not end well:\n" + log);
  return std::stod(log.substr(at + before.size()));
}

State<Eigen::Matrix3Xd> read_dump(const fs::path& file, Eigen::Index count) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0;) {
  }
  State<Eigen::Matrix3Xd> balls{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0, id = 0; i < count; ++i) {
    auto p = balls.position.col(i), v = balls.velocity.col(i);
    in >> id >> p.x() >> p.z() >> p.y() >> v.x() >> v.z() >> v.y();
    if (!in || id != i + 1) throw std::runtime_error("lmp has lost a ball");
  }
  return balls;
}

}  // namespace

std::optional<LammpsRun> run_lammps(const Crowd& start, long steps, double dt) {
  if (std::system("command -v lmp >/dev/null") != 0) return std::nullopt;
  const TemporaryFolder own;
  const fs::path& folder = own.path();
  write_data(start, folder / "balls.data");
  write_input(start, steps, dt, folder / "in.bounce");
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 lmp -in in.bounce >out 2>&1";
  const int status = std::system(command.c_str());
  std::ostringstream log;
  log << std::ifstream(folder / "out").rdbuf();
  const double seconds = loop_seconds(log.str());
  if (status != 0) throw std::runtime_error("lmp did not end well:\n" + log.str());
  return LammpsRun{read_dump(folder / "balls.dump", start.scene.mass.size()), seconds};
}

}  // namespace bounce::test
