// Stage 5 hands its balls to LAMMPS and takes them back. (The journey through LAMMPS itself is in
// lammps_round_trip_long_test.cpp.)

#include <unistd.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "run_program.hpp"

using namespace bounce;
using test::contains;
using test::Outcome;
using test::run_program;

namespace {

namespace fs = std::filesystem;

const std::string balls_program = "05_ball_collision ";
const std::string verlet = "--method velocity-verlet --dt 1e-4 --duration 0.1 ";

std::size_t files_left() {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(test::work_folder()), {}));
}

struct TemporaryFile {
  std::string path;
  explicit TemporaryFile(const std::string& name, const std::string& text)
      : path((fs::temp_directory_path() / (name + "." + std::to_string(getpid()))).string()) {
    std::ofstream(path, std::ios::binary) << text;
  }
  ~TemporaryFile() { fs::remove(path); }
};

Outcome import(const std::string& text, const std::string& more) {
  const TemporaryFile dump("bounce_test.dump", text);
  return run_program(balls_program + "--headless " + more + " --import-lammps " + dump.path);
}

const std::string dump_header =
    "ITEM: TIMESTEP\n500\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ss ss ss\n0 1\n0 1\n0 1\n";
const std::string columns = "ITEM: ATOMS id x y z vx vy vz\n";

}  // namespace

TEST_CASE("--export-lammps writes balls, input script and a README of three lines, and ends") {
  const Outcome run =
      run_program(balls_program + verlet +
                  "--set scene=drop --set count=50 --set damping=30 --export-lammps out/");
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(files_left() == 1);
  const std::string folder = test::work_folder() + "/out/";
  const std::string script = test::read_file(folder + "in.bounce");
  for (const char* line :
       {"\nunits si\n", "pair_style gran/hooke 20000 0 60 0 0 0 ", "vector 0 -1 0\n",
        "wall/gran hooke 20000 0 20 0 0 0 yplane 0 NULL", "xplane 0 ", "zplane 0 ",
        "fix move all nve ", "timestep 1e-04\n", "run 1000\n"}) {
    INFO(line);
    CHECK(contains(script, line));
  }
  CHECK(contains(test::read_file(folder + "balls.data"), "\n50 atoms\n"));
  const std::string readme = test::read_file(folder + "README");
  CHECK(std::count(readme.begin(), readme.end(), '\n') == 3);
  CHECK(contains(readme, "mpirun -np 4 lmp -in in.bounce"));
}

TEST_CASE("what LAMMPS would compute otherwise is not exported: exit code 2, and nothing left") {
  const TemporaryFile unequal("bounce_unequal.csv",
                              "mass,radius,x,y,z,vx,vy,vz\n1,0.1,0,1,0,0,0,0\n2,0.1,1,1,0,0,0,0\n");
  const TemporaryFile below("bounce_below.csv",
                            "mass,radius,x,y,z,vx,vy,vz\n1,0.1,0,-0.01,0,0,0,0\n");
  const TemporaryFile one("bounce_one_place.csv",
                          "mass,radius,x,y,z,vx,vy,vz\n1,0.1,0,1,0,0,0,0\n1,0.1,0,1,0,0,0,0\n");
  const struct {
    std::string words, says;
  } refused[] = {
      {"--method rk4", "velocity-verlet"},
      {verlet + "--set damping=1 --set contact=push-only", "contact=may-pull"},
      {verlet + "--set damping=1 --balls " + unequal.path, "same mass"},
      {verlet + "--set floor_damping=1 --balls " + unequal.path, "same mass"},
      {verlet + "--balls " + below.path, "beyond"},
      {verlet + "--balls " + one.path, "same centre"},
      {verlet + "--set scene=drop --set tray=0.09,1", "narrower"},
      {"--method velocity-verlet --dt 3e-4 --duration 0.1", "whole"},
  };
  for (const auto& wrong : refused) {
    const Outcome run = run_program(balls_program + wrong.words + " --export-lammps out");
    INFO(wrong.words, "\n", run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, wrong.says));
    CHECK(files_left() == 0);
  }
  // Without damping, neither the mass nor the pull before lift-off makes a difference.
  CHECK(run_program(balls_program + verlet + "--set contact=push-only --export-lammps out").code ==
        0);
  CHECK(run_program(balls_program + verlet + "--balls " + unequal.path + " --export-lammps out")
            .code == 0);
}

TEST_CASE("a folder that is not empty stays as it is, and one that is half written goes" *
          doctest::skip(test::on_windows)) {  // its shell has no touch and no limit
  const std::string run_it = balls_program + verlet + "--set scene=drop --export-lammps ";
  CHECK(test::run_program_with("mkdir out; touch out/mine;", run_it + "out").code == 2);
  CHECK(fs::exists(test::work_folder() + "/out/mine"));
  CHECK(files_left() == 1);
  CHECK(test::run_program_with("mkdir out;", run_it + "out").code == 0);
  CHECK(test::run_program_with("touch out;", run_it + "out").code == 2);
  CHECK(run_program(run_it + "no/such/place").code == 2);
  CHECK(run_program(run_it + "''").code == 2);
  // As on a full disk: no file may grow beyond 4 kB.
  const Outcome full = test::run_program_with("trap '' XFSZ; ulimit -f 8;", run_it + "out");
  INFO(full.err);
  CHECK(full.code == 1);
  CHECK(files_left() == 0);
}

TEST_CASE("--import-lammps goes on from the last frame, whatever the order of its rows") {
  const std::string early =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS id x y z vx vy vz\n1 9 9 9 9 9 9\n";
  const Outcome run = import(early + dump_header +
                                 "ITEM: ATOMS type vx vy vz id radius z y x mass\n"
                                 "1 0 0 -1 2 0.25 3 2 1 4\n1 0.5 0 0 1 0.125 0 1 0 2\n",
                             "--dt 0.0078125 --duration 4.90625 --csv - --at 3.90625,4.90625");
  INFO(run.err);
  CHECK(run.code == 0);
  // Step 500 is at t = 3.90625 s. (The scene `pair` has no gravity.)
  CHECK(run.out ==
        "t,ball,x,y,z,vx,vy,vz\n"
        "3.90625,0,0,1,0,0.5,0,0\n3.90625,1,1,2,3,0,0,-1\n"
        "4.90625,0,0.5,1,0,0.5,0,0\n4.90625,1,1,2,2,0,0,-1\n");
}

TEST_CASE("a damaged dump is refused, with its line") {
  const std::string good = dump_header + columns + "1 0 1 0 0 0 0\n2 0 2 0 0 0 0\n";
  CHECK(import(good, "").code == 0);
  const struct {
    std::string text, says;
  } bad[] = {
      {"", "line 1:"},
      {"hello\n", "line 1: 'hello'"},
      {good.substr(0, good.size() - 14), "line 11: the file ends"},
      {good.substr(0, good.size() - 6), "line 11: there are 4 values for 7"},
      {dump_header + columns + "1 0 1 0 0 0 0\n1 0 2 0 0 0 0\n", "line 11: ball 1 comes twice"},
      {dump_header + columns + "1 0 1 0 0 0 0\n3 0 2 0 0 0 0\n", "line 11: column id: '3'"},
      {dump_header + columns + "1 0 1 0 nan 0 0\n2 0 2 0 0 0 0\n", "line 10: column vx: 'nan'"},
      {dump_header + "ITEM: ATOMS id x y z vx vy\n", "line 9: column vz is missing"},
      {good + "ITEM: TIMESTEP\n", "line 13: the file ends"},
      {"ITEM: TIMESTEP\nsoon\n", "line 2: TIMESTEP: 'soon'"},
      {"ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n0\n",
       "line 4: NUMBER OF ATOMS: '0' must be a whole number from 1"},
      {"ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n999999999\n" + columns, "line 6: the file ends"},
  };
  for (const auto& damaged : bad) {
    const Outcome run = import(damaged.text, "");
    INFO(damaged.text, run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, damaged.says));
  }
  CHECK(run_program(balls_program + "--headless --import-lammps .").code == 2);
  CHECK(run_program(balls_program + "--headless --import-lammps no_such_file").code == 2);
  const Outcome other = import(good, "--set scene=drop");
  CHECK(other.code == 2);
  CHECK(contains(other.err, "mass and radius"));
}
