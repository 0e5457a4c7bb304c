// What stage 5 has on the command line besides what all stages have.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "run_program.hpp"

using namespace bounce;
using test::contains;
using test::Outcome;
using test::run_program;

namespace {

const std::string program = "05_ball_collision ";

std::string temporary(const std::string& name) {
  return (std::filesystem::temp_directory_path() / name).string();
}

/// A balls file with this text, in the system's folder for such things.
std::string balls_file(const std::string& text) {
  const std::string path =
      temporary("bounce_balls_" + std::to_string(std::hash<std::string>{}(text)) + ".csv");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

const std::string header = "mass,radius,x,y,z,vx,vy,vz\n";

}  // namespace

TEST_CASE("stage 5 writes a row for each ball") {
  const std::string two = header + "1,0.1,0,1,0,0.5,0,0\n2,0.2,1,1,0,0,0,-1\n";
  const Outcome run =
      run_program(program + "--headless --dt 0.0078125 --set gravity=0 --csv - --at 0,2 --balls " +
                  balls_file(two));
  CHECK(run.code == 0);
  CHECK(run.out ==
        "t,ball,x,y,z,vx,vy,vz\n"
        "0,0,0,1,0,0.5,0,0\n0,1,1,1,0,0,0,-1\n"
        "2,0,1,1,0,0.5,0,0\n2,1,1,1,-2,0,0,-1\n");
  CHECK(contains(run.err, "ns_per_step_and_ball="));
}

TEST_CASE("a balls file that is not right ends with 2, and with its line and column") {
  const auto fails = [](const std::string& text, const std::string& says) {
    const Outcome run =
        run_program(program + "--headless --csv out.csv --balls " + balls_file(text));
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(contains(run.err, says));
    CHECK(test::read_file(test::work_folder() + "/out.csv").empty());
  };
  fails("", "line 1");
  fails("mass,radius,x,y,z,vx,vy\n1,0.1,0,0,0,0,0\n", "line 1: column vz");
  fails(header + "1,0.1,0,0,0,0,0,0\n1,0.1,0,abc,0,0,0,0\n", "line 3: column y: 'abc'");
  fails(header + "1,0.1,0,nan,0,0,0,0\n", "line 2: column y: 'nan'");
  fails(header + "-1,0.1,0,0,0,0,0,0\n", "line 2: column mass: '-1'");
  fails(header + "1,0,0,0,0,0,0,0\n", "line 2: column radius: '0'");
  CHECK(run_program(program + "--headless --balls no_such_file.csv").code == 2);
  CHECK(run_program(program + "--headless --balls .").code == 2);
  // Deep overlap at the start is allowed.
  const std::string deep = header + "1,0.1,0,1,0,0,0,0\n1,0.1,0,1,0,0,0,0\n";
  CHECK(run_program(program + "--headless --balls " + balls_file(deep)).code == 0);
}

TEST_CASE("--balls takes the place of a scene") {
  const std::string file = balls_file(header + "1,0.1,0,1,0,0,0,0\n");
  const Outcome run = run_program(program + "--headless --set scene=drop --balls " + file);
  CHECK(run.code == 2);
  CHECK(contains(run.err, "scene"));
  CHECK(run_program(program + "--headless --set damping=3 --balls " + file).code == 0);
}

TEST_CASE("--threads: validated, and the result does not depend on it") {
  for (const std::string bad : {"0", "-1", "1.5", "many", "nan", "100000"}) {
    const Outcome run = run_program(program + "--headless --threads " + bad);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "--threads '" + bad + "'"));
  }
  const std::string drop = "--set scene=drop --headless --csv - --at 0.5 --threads ";
  CHECK(run_program(program + drop + "1").out == run_program(program + drop + "2").out);
}

TEST_CASE("a scene's defaults give way to what is set, wherever it stands") {
  const std::string rest = " --headless --csv - --at 0.2";
  const Outcome before = run_program(program + "--set gravity=3 --set scene=cradle" + rest);
  const Outcome after = run_program(program + "--set scene=cradle --set gravity=3" + rest);
  CHECK(before.out == after.out);
  CHECK(before.out != run_program(program + "--set scene=cradle" + rest).out);
  CHECK(run_program(program + "--set scene=drop --seed 2" + rest).out !=
        run_program(program + "--set scene=drop" + rest).out);
  const Outcome bad = run_program(program + "--headless --set count=2.5");
  CHECK(bad.code == 2);
  CHECK(contains(bad.err, "a whole number from 1"));
}

TEST_CASE("a saved run of many balls goes on to the bit") {
  const std::string state = temporary("bounce_many_balls.state");
  const std::string own =
      "--balls " + balls_file(header + "1,0.1,0,1,0,0,0,0\n2,0.2,0.1,1.3,0,0,0,0\n");
  const std::string scene = "--set scene=drop --set count=70 --set damping=9";
  for (const std::string& start : {scene, own}) {
    for (const std::string method : {"semi-implicit-euler", "velocity-verlet", "rk4"}) {
      const std::string how = start + " --method " + method;
      const Outcome through = run_program(program + how + " --csv - --at 0.6 --duration 0.6");
      CHECK(run_program(program + how + " --headless --duration 0.3 --save " + state).code == 0);
      const Outcome on =
          run_program(program + "--load " + state + " --csv - --at 0.6 --duration 0.6");
      INFO(how, on.err);
      CHECK(on.code == 0);
      CHECK(on.out == through.out);
    }
  }
  std::remove(state.c_str());
}

TEST_CASE("stage 5's reference: rows at the times asked for, a tolerance, and a saved run") {
  const std::string break_up = program + "--method reference --set scene=break ";
  const std::string how = break_up + "--set damping=5 --set contact=push-only ";
  const Outcome through = run_program(how + "--csv - --at 0.3,0.31,2 --duration 2");
  CHECK(through.code == 0);
  CHECK(through.out.find("\n0.31,15,") != std::string::npos);
  // 0.31 s is in the middle of the collision: those who touch are saved with the balls.
  const std::string state = temporary("bounce_reference.state");
  CHECK(run_program(how + "--headless --duration 0.31 --save " + state).code == 0);
  const Outcome on = run_program(program + "--load " + state + " --csv - --at 2 --duration 2");
  CHECK(on.code == 0);
  CHECK(on.out.substr(on.out.find("\n2,0,")) == through.out.substr(through.out.find("\n2,0,")));
  std::remove(state.c_str());

  // One row an event: the start, the touch, the lift-off, the end.
  const Outcome events = run_program(program + "--method reference --csv - --duration 2");
  CHECK(std::count(events.out.begin(), events.out.end(), '\n') == 1 + 4 * 2);
  CHECK(contains(events.err, "tolerance=1e-12"));
  CHECK(run_program(how + "--headless --tolerance 2").code == 2);

  const Outcome many =
      run_program(program + "--headless --method reference --set scene=drop " + "--set count=1001");
  CHECK(many.code == 2);
  CHECK(contains(many.err, "--method reference is not allowed with 1001 balls"));
  CHECK(contains(many.err, "at most 1000 balls"));
}

TEST_CASE("a run of a few balls says how far it is from the reference") {
  const Outcome coarse = run_program(program + "--headless --dt 1e-3 --duration 2");
  const Outcome fine = run_program(program + "--headless --dt 1e-6 --duration 2");
  const auto error_of = [](const Outcome& run) {
    const std::string name = "position_error_m=";
    REQUIRE(contains(run.err, name));
    return std::stod(run.err.substr(run.err.find(name) + name.size()));
  };
  CHECK(error_of(coarse) > 1e-4);
  CHECK(error_of(fine) < 1e-5);
  const Outcome many = run_program(program + "--headless --set scene=break --duration 1");
  CHECK(!contains(many.err, "position_error_m="));
}

TEST_CASE("1000 balls in a heap, saved at any step, go on to the bit on the fast path") {
  // The neighbour list of the run that goes on is a new one: no result may depend on its age.
  const std::string state = temporary("bounce_heap.state");
  const std::string heap = "--set scene=drop --set count=1000 --dt 2e-4 --threads ";
  for (const std::string method : {"semi-implicit-euler", "velocity-verlet"}) {
    const std::string how = heap + "2 --method " + method;
    const Outcome through = run_program(program + how + " --csv - --at 0.5 --duration 0.5");
    for (const std::string stop : {"0.3", "0.3002", "0.4321"}) {
      const std::string cut = " --headless --duration " + stop + " --save ";
      REQUIRE(run_program(program + how + cut + state).code == 0);
      const std::string rest = " --csv - --at 0.5 --duration 0.5";
      const Outcome on = run_program(program + "--load " + state + rest);
      INFO(how, " ", stop, on.err);
      CHECK(on.code == 0);
      // A stop between two steps cuts one, in the run without a stop as well.
      const Outcome same =
          stop == "0.4321" ? run_program(program + how + " --csv - --at 0.4321,0.5 --duration 0.5")
                           : through;
      CHECK(on.out.substr(on.out.find("\n0.5,")) == same.out.substr(same.out.find("\n0.5,")));
    }
  }
  std::remove(state.c_str());
}

TEST_CASE("the saved state of many balls is compact, and damage to it is noticed") {
  const std::string state = temporary("bounce_damaged_heap.state");
  const Outcome run = run_program(
      program + "--headless --set scene=drop --set count=1000 --duration 0.01 --save " + state);
  REQUIRE(run.code == 0);
  const std::string good = test::read_file(state);
  CHECK(good.size() < 8 * 8 * 1000 + 1000);  // mass, radius, position, velocity, and the header
  const auto refused = [&](const std::string& bytes, const std::string& says) {
    std::ofstream(state, std::ios::binary) << bytes;
    const Outcome load = run_program(program + "--headless --load " + state);
    INFO(load.err);
    CHECK(load.code == 2);
    CHECK(contains(load.err, says));
  };
  for (std::size_t at = 60; at < good.size(); at += good.size() / 20) {
    std::string flipped = good;
    flipped[at] = static_cast<char>(flipped[at] ^ 1);  // one bit
    refused(flipped, "damaged");
    refused(good.substr(0, at), "damaged");
  }
  refused(good + "x", "damaged");
  std::string newer = good;
  newer.replace(newer.find("version 2"), 9, "version 9");
  refused(newer, "a newer program wrote it (version 9");
  std::remove(state.c_str());
}
