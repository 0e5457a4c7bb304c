// To LAMMPS (Debian: lammps, openmpi-bin) on two processes, and back.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "physics/text.hpp"
#include "run_program.hpp"

using namespace bounce;
using test::Outcome;
using test::run_program;

namespace {

namespace fs = std::filesystem;

/// The largest difference between two traces with the same rows.
double difference(const std::string& a, const std::string& b) {
  std::istringstream rows_a(a), rows_b(b);
  double largest = 0;
  std::string row_a, row_b;
  while (std::getline(rows_a, row_a)) {
    REQUIRE(std::getline(rows_b, row_b));
    const std::vector<std::string> words_a = split(row_a), words_b = split(row_b);
    REQUIRE(words_a.size() == words_b.size());
    for (std::size_t i = 0; i < words_a.size(); ++i) {
      const auto x = parse_number(words_a[i]), y = parse_number(words_b[i]);
      REQUIRE(x.has_value() == y.has_value());
      if (x) largest = std::max(largest, std::abs(*x - *y));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("1000 balls through LAMMPS on two processes are where they are without it") {
  if (std::system("command -v lmp >/dev/null && command -v mpirun >/dev/null") != 0) {
    MESSAGE("skipped: lmp or mpirun is missing (Debian: lammps, openmpi-bin)");
    return;
  }
  const fs::path folder = fs::temp_directory_path() / "bounce_round_trip";
  fs::remove_all(folder);
  const std::string run =
      "05_ball_collision --method velocity-verlet --dt 1e-4 --set scene=drop --set count=1000 "
      "--set stiffness=1e5 --set floor_stiffness=1e5 --set damping=100 --set floor_damping=100 ";
  // The heap collapses on the floor from 0.2 s on.
  REQUIRE(
      run_program(run + "--duration 0.3 --export-lammps " + test::quoted(folder.string())).code ==
      0);
  const std::string mpi =
      "cd " + test::quoted(folder.string()) +
      " && OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "timeout 300 mpirun --oversubscribe -np 2 lmp -in in.bounce > out 2>&1 < /dev/null";
  const int status = std::system(mpi.c_str());
  INFO(test::read_file((folder / "out").string()));
  REQUIRE(status == 0);

  // 3000 steps of rounding, which every collision amplifies; measured 1e-13 (m and m/s) at the time
  // of the dump, and 3e-13 after 200 steps more. Where velocity Verlet does not get back the forces
  // that stand in the dump, those are 0.01.
  const auto check = [&](const std::string& time, double tolerance) {
    const std::string at = "--csv - --at " + time + " --duration 0.32";
    const Outcome through = run_program(run + at);
    const Outcome back = run_program(run + at + " --import-lammps " +
                                     test::quoted((folder / "balls.dump").string()));
    INFO(back.err);
    REQUIRE(back.code == 0);
    CHECK(difference(through.out, back.out) < tolerance);
  };
  check("0.3", 1e-12);
  check("0.32", 1e-11);
  fs::remove_all(folder);
}
