// Writes lammps_reference.csv: where LAMMPS has the balls of `collapse(1000)` after 1000 steps.

#include <cstdio>
#include <exception>

#include "many_balls/lammps.hpp"

int main() try {
  const auto run = bounce::test::run_lammps(bounce::test::collapse(1000), 1000, 1e-4);
  if (!run) {
    std::fprintf(stderr, "lmp is missing (Debian: lammps)\n");
    return 1;
  }
  std::FILE* file = std::fopen(BOUNCE_SOURCE_DIR "/tests/many_balls/lammps_reference.csv", "w");
  if (file == nullptr) return 1;
  std::fprintf(file, "# x,y,z [m] of 1000 balls after 1000 steps in LAMMPS (29 Sep 2021)\n");
  for (const auto& p : run->balls.position.colwise()) {
    std::fprintf(file, "%.16g,%.16g,%.16g\n", p.x(), p.y(), p.z());
  }
  return std::fclose(file) == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
