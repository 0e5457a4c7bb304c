// What the command line refuses, and what it says and leaves when a run goes wrong.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "physics/text.hpp"
#include "run_program.hpp"

using namespace bounce;
using test::contains;
using test::files;
using test::lines;
using test::Outcome;
using test::run_program;

TEST_CASE("a damaged, foreign or missing saved state is refused") {
  const std::string state =
      (std::filesystem::temp_directory_path() / "bounce_damaged_state").string();
  REQUIRE(run_program("03_damping --headless --duration 1 --save " + state).code == 0);
  const std::string text = test::read_file(state);
  const auto refused = [&](const std::string& content, const std::string& stage) {
    std::ofstream(state) << content;
    const Outcome run = run_program(stage + " --headless --load " + state);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "--load"));
    CHECK(lines(run.err).size() == 1);
  };
  // Another system's ends of lines, and an editor's mark, are no damage.
  std::string windows = "\xEF\xBB\xBF";
  for (const char letter : text) windows += letter == '\n' ? "\r\n" : std::string(1, letter);
  std::ofstream(state, std::ios::binary) << windows;
  CHECK(run_program("03_damping --headless --load " + state + " --duration 2").code == 0);
  std::string damaged = text;
  damaged.replace(damaged.find("set.mass 1"), 10, "set.mass 2");
  refused(damaged, "03_damping");
  refused(text.substr(0, text.size() / 2), "03_damping");
  refused("", "03_damping");
  refused("hello\n", "03_damping");
  refused(text, "02_spring_floor");
  std::string newer = text;
  newer.replace(newer.find("version 2"), 9, "version 3");
  refused(newer, "03_damping");
  std::string no_version = text;
  no_version.replace(no_version.find("version 2"), 9, "version x");
  refused(no_version, "03_damping");
  std::filesystem::remove(state);
  CHECK(run_program("03_damping --headless --load /nowhere/at/all").code == 2);
}

TEST_CASE(
    "bad input: exit code 2, one sentence with name, value and what is allowed, nothing written") {
  struct Row {
    std::string options, name, value, allowed;
  };
  const Row rows[] = {
      {"--dt 0", "--dt", "0", "1e-15"},
      {"--dt -0.1", "--dt", "-0.1", "1e-15"},
      {"--dt fast", "--dt", "fast", "auto"},
      {"--dt nan", "--dt", "nan", "1e-15"},
      {"--dt inf", "--dt", "inf", "1e-15"},
      {"--dt 1e-3x", "--dt", "1e-3x", "number"},
      {"--dt ''", "--dt", "", "number"},
      {"--duration 0", "--duration", "0", "1e-15"},
      {"--duration -1", "--duration", "-1", "1e-15"},
      {"--duration NaN", "--duration", "NaN", "number"},
      {"--set mass=0", "mass", "0", "1e-30"},
      {"--set mass=-2", "mass", "-2", "1e-30"},
      {"--set mass=heavy", "mass", "heavy", "number"},
      {"--set mass=nan", "mass", "nan", "number"},
      {"--set mass=-inf", "mass", "-inf", "number"},
      {"--set mass=1e308", "mass", "1e308", "1e+30"},
      {"--set mass=1e-320", "mass", "1e-320", "1e-30"},
      {"--set mass=1,2", "mass", "1,2", "number"},
      {"--set mass=", "mass", "", "number"},
      {"--set radius=0", "radius", "0", "1e-30"},
      {"--set radius=-0.1", "radius", "-0.1", "1e-30"},
      {"--set stiffness=0", "stiffness", "0", "1e-30"},
      {"--set stiffness=-1e4", "stiffness", "-1e4", "1e-30"},
      {"--set damping=-1", "damping", "-1", "0 to"},
      {"--set gravity=-9.81", "gravity", "-9.81", "0 to"},
      {"--set position=up", "position", "up", "number"},
      {"--set contact=sticky", "contact", "sticky", "may-pull or push-only"},
      {"--set stifness=3", "stifness", "did you mean stiffness", "damping"},
      {"--set damping", "--set", "damping", "NAME=VALUE"},
      {"--set =3", "parameter", "''", "mass"},
      {"--method rk5", "--method", "did you mean rk4", "explicit-euler"},
      {"--metod rk4", "--metod", "did you mean --method", "--help"},
      {"--nonsense", "--nonsense", "", "--help"},
      {"mass=3", "mass=3", "", "--set"},
      {"--dt", "--dt", "", "value"},
      {"--dt 1e-3 --dt 1e-4", "--dt", "", "value"},
      {"--sample 0 --csv -", "--sample", "0", "1e-15"},
      {"--at 1,x --csv -", "--at", "x", "0 to 10"},
      {"--at 11 --csv -", "--at", "11", "0 to 10"},
      {"--at -1 --csv -", "--at", "-1", "0 to 10"},
      {"--at 1,,2 --csv -", "--at", "''", "0 to 10"},
      {"--at 1 --sample 1 --csv -", "--at", "--sample", "one of them"},
      {"--dt 1e-12 --duration 1", "--dt", "1e-12", "1e11"},
      {"--csv - --dt 1e-8 --duration 2", "--csv", "rows", "1e8"},
      {"--csv - --sample 1e-9", "--csv", "rows", "1e8"},
      {"--seed 1.5", "--seed", "1.5", "whole"},
      {"--seed -1", "--seed", "-1", "0 to"},
      {"--tolerance 0", "--tolerance", "0", "1e-15"},
      {"--csv /nowhere/x.csv", "--csv", "/nowhere/x.csv", "folder"},
      {"--csv .", "--csv", ".", "file"},
      {"--save /nowhere/x --headless", "--save", "/nowhere/x", "folder"},
      {"--csv ''", "--csv", "''", "path"},
      {"--csv= --calm", "--csv=", "", "value"},
      {"--dt=-inf", "--dt", "-inf", "1e-15"},
      {"--at=-inf --csv -", "--at", "-inf", "0 to 10"},
      {"--screenshot ''", "--screenshot", "''", "path"},
      {"--load /nowhere/x --dt 1e-3", "--load", "--dt", "leave out"},
  };
  for (const Row& row : rows) {
    // A trace is asked for in each case: it must not appear.
    const bool has_csv = contains(row.options, "--csv");
    const Outcome run = run_program("03_damping --headless " +
                                    std::string(has_csv ? "" : "--csv out.csv ") + row.options);
    CAPTURE(row.options);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(lines(run.err).size() == 1);
    CHECK(contains(run.err, row.name));
    CHECK(contains(run.err, row.value));
    CHECK(contains(run.err, row.allowed));
    CHECK(files().empty());
  }
}

TEST_CASE("bad input leaves a file that was there before as it was") {
  const std::string path =
      (std::filesystem::temp_directory_path() / "bounce_old_trace.csv").string();
  std::ofstream(path) << "precious";
  CHECK(run_program("03_damping --headless --dt -1 --csv " + test::quoted(path)).code == 2);
  CHECK(test::read_file(path) == "precious");
  std::filesystem::remove(path);
}

TEST_CASE("a state that becomes infinite: exit code 3, the time, and a step that is stable") {
  // A ball that explodes is thrown into the air, and so rarely gets to infinity. This one does:
  // c dt / m is 1e70, and the slopes of one Runge-Kutta step multiply by it in turn.
  const Outcome run = run_program(
      "03_damping --headless --csv out.csv --method rk4 --dt 1e10 --duration 1e12 --set mass=1e-30 "
      "--set damping=1e30 --set stiffness=1e30 --set position=0.05 --set velocity=-1");
  CAPTURE(run.err);
  CHECK(run.code == 3);
  CHECK(contains(run.err, "non-finite after t = "));
  CHECK(contains(run.err, "stable up to "));
  const std::string trace = test::read_file(test::work_folder() + "/out.csv");
  CHECK(!contains(trace, "nan"));
  CHECK(!contains(trace, "inf"));
  CHECK(lines(trace).size() >= 2);
}

TEST_CASE("reference: a contact of a few spacings of doubles ends with exit code 3") {
  // The ball lands after 4.5e6 s, where neighbouring doubles are 1 ns apart. It touches for 31 ns.
  const Outcome run = run_program(
      "03_damping --headless --method reference --set position=1e14 --set velocity=-1e3 "
      "--set stiffness=1e16 --duration 1e12");
  CAPTURE(run.err);
  CHECK(run.code == 3);
}

TEST_CASE("extreme but valid parameters run, or end with a sentence") {
  for (const std::string options :
       {"--set mass=1e-12 --set stiffness=1e9", "--set mass=1e6",
        "--set mass=1e-30 --set stiffness=1e30", "--set position=-0.5", "--set position=1e15",
        "--set gravity=0", "--set gravity=0 --set velocity=-1", "--set radius=1e-30",
        "--set damping=1e30", "--set position=0", "--set velocity=1e-320"}) {
    for (const std::string method : {"semi-implicit-euler", "rk4", "exact"}) {
      const Outcome run = run_program("03_damping --headless --csv - --sample 1 --method " +
                                      method + " " + options);
      CAPTURE(options);
      CAPTURE(method);
      CAPTURE(run.err);
      if (run.code == 0) {
        CHECK(lines(run.out).size() == 12);  // a head, and t = 0 to 10 s
      } else {
        CHECK(run.code == 3);
        CHECK(contains(run.err, "the state became non-finite after t = "));
        CHECK(contains(run.err, method + " is stable up to "));
      }
      CHECK(!contains(run.out, "nan"));
      CHECK(!contains(run.out, "inf"));
    }
  }
}

TEST_CASE("a full disk is the machine's fault: exit code 1" * doctest::skip(test::on_windows)) {
  const Outcome run = run_program("03_damping --headless --csv /dev/full");
  CHECK(run.code == 1);
  CHECK(contains(run.err, "/dev/full"));
  // A device is no file to be replaced: it is written directly, and stays what it is.
  CHECK(run_program("03_damping --headless --csv /dev/null").code == 0);
  CHECK(!std::filesystem::exists("/dev/null.part"));
}

TEST_CASE("an answer that nobody could read is the machine's fault: exit code 1" *
          doctest::skip(test::on_windows)) {
  for (const std::string question : {"--list", "--help"}) {
    const Outcome run =
        test::run_program_with("sh -c '\"$0\" \"$@\" > /dev/full'", "03_damping " + question);
    CHECK(run.code == 1);
    CHECK(contains(run.err, question + " could not be written"));
  }
}

TEST_CASE("two outputs in one file are refused") {
  for (const std::string options :
       {"--csv a --save ./a", "--csv a.png --screenshot a.png", "--record a.gif --save a.gif"}) {
    const Outcome run = run_program("03_damping --headless --duration 0.1 " + options);
    CAPTURE(options);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "the same file"));
    CHECK(files().empty());
  }
}

TEST_CASE("a trace that does not fit on the disk leaves the old one as it was" *
          doctest::skip(test::on_windows)) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "bounce_limited_trace.csv").string();
  std::ofstream(path) << "precious";
  const Outcome run =
      test::run_program_with("trap '' XFSZ; ulimit -f 16;", "03_damping --headless --csv " + path);
  CHECK(run.code == 1);
  CHECK(test::read_file(path) == "precious");
  std::filesystem::remove(path);
}
