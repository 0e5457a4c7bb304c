// The command line as another program drives it: rows, summaries, saved runs.

#include <doctest/doctest.h>

#include <filesystem>
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

namespace {

const std::string stages[] = {"01_free_fall", "02_spring_floor", "03_damping"};

double last_value(const std::string& row) { return parse_number(split(row).back()).value(); }

}  // namespace

TEST_CASE("words are joined and split again, the empty ones, too") {
  const std::vector<std::vector<std::string>> rows{
      {"a", "b"}, {"", "a"}, {"a", ""}, {"", ""}, {""}};
  for (const std::vector<std::string>& words : rows) CHECK(split(join(words, ",")) == words);
  CHECK(join({}) == "");
  CHECK(join({"", "b", "c"}) == ", b, c");
}

TEST_CASE("--at gives rows at exactly these times") {
  for (const std::string& stage : stages) {
    for (const std::string method :
         {"explicit-euler", "semi-implicit-euler", "velocity-verlet", "rk4", "exact"}) {
      const Outcome run =
          run_program(stage + " --headless --csv - --at 0.5,1,2 --method " + method);
      CAPTURE(run.err);
      CHECK(run.code == 0);
      const auto rows = lines(run.out);
      REQUIRE(rows.size() == 4);
      CHECK(rows[0] == "t,y,v");
      CHECK(rows[1].rfind("0.5,", 0) == 0);
      CHECK(rows[2].rfind("1,", 0) == 0);
      CHECK(rows[3].rfind("2,", 0) == 0);
    }
  }
}

TEST_CASE("--sample gives rows at 0, S, 2 S, ..., and every step without it") {
  const auto sampled =
      lines(run_program("03_damping --csv - --sample 0.25 --duration 1 --dt 0.003").out);
  REQUIRE(sampled.size() == 6);
  CHECK(sampled[1] == "0,1,0");
  CHECK(sampled[2].rfind("0.25,", 0) == 0);
  CHECK(sampled[5].rfind("1,", 0) == 0);
  const auto every = lines(run_program("03_damping --csv - --duration 1 --dt 0.3").out);
  REQUIRE(every.size() == 6);  // header, 0, 0.3, 0.6, 0.9, 1
  CHECK(every[5].rfind("1,", 0) == 0);
  // A step that divides the duration leaves no stray row a rounding before its end.
  CHECK(lines(run_program("03_damping --csv - --duration 0.7 --dt 0.1").out).size() == 9);
}

TEST_CASE("exact writes one row an event") {
  const auto rows = lines(run_program("03_damping --method exact --csv - --duration 1").out);
  REQUIRE(rows.size() == 5);  // header, start, touch, lift-off, end
  CHECK(split(rows[2])[1] == "0.1");
  CHECK(split(rows[3])[1] == "0.1");
  CHECK(last_value(rows[2]) < 0);
  CHECK(last_value(rows[3]) > 0);
}

TEST_CASE("landing on a time between two steps does not disturb the steps after it") {
  // The cut step is made in two parts, a and b, and the steps after it end at multiples of dt as
  // before. In free fall both parts together fall g (a^2 + a b + b^2), the whole step g (a + b)^2:
  // the ball stays g a b higher, and has the same velocity.
  const auto cut = lines(run_program("01_free_fall --csv - --at 0.40035,0.401,1 --dt 0.001").out);
  const auto whole = lines(run_program("01_free_fall --csv - --at 0.401,1 --dt 0.001").out);
  REQUIRE(cut.size() == 4);
  REQUIRE(whole.size() == 3);
  for (const std::size_t row : {1UL, 2UL}) {
    const auto height = [](const std::string& line) {
      return parse_number(split(line)[1]).value();
    };
    const double higher = height(cut[row + 1]) - height(whole[row]);
    CHECK(higher == doctest::Approx(9.81 * 0.35e-3 * 0.65e-3).epsilon(1e-6));
    CHECK(last_value(cut[row + 1]) == doctest::Approx(last_value(whole[row])).epsilon(1e-13));
  }
}

TEST_CASE("blanks beside a comma or an equals sign are no part of a number") {
  const std::string sums = run_program("03_damping --csv - --at 0.5,1 --set stiffness=2000").out;
  CHECK(run_program("03_damping --csv - --at '0.5, 1' --set 'stiffness = 2000'").out == sums);
  CHECK(lines(sums).size() == 3);
}

TEST_CASE("a time that is one rounding beyond the end is at the end") {
  const std::string run = "01_free_fall --duration 0.3 --csv - --at ";
  CHECK(contains(run_program(run + "0.30000000000000004").out, "\n0.30000000000000004,"));
  CHECK(run_program(run + "0.3001").code == 2);
}

TEST_CASE("two whole times may be meant as one decimal: the run says how it reads them") {
  const Outcome run = run_program("01_free_fall --csv - --at 0,5");
  CHECK(contains(run.err, "--at 0,5 is two times, 0 s and 5 s; a decimal has a point"));
  CHECK(lines(run.out).size() == 3);
  CHECK(lines(run_program("01_free_fall --csv - --at 0.5,1").err).size() == 1);
}

TEST_CASE("rows every tenth of a second have the times that one writes") {
  const std::vector<std::string> rows =
      lines(run_program("01_free_fall --csv - --sample 0.1 --duration 1").out);
  REQUIRE(rows.size() == 12);
  for (const auto& [row, t] : {std::pair{4, "0.3,"}, {7, "0.6,"}, {8, "0.7,"}, {11, "1,"}}) {
    CHECK(rows[static_cast<std::size_t>(row)].rfind(t, 0) == 0);
  }
}

TEST_CASE(
    "what dampers took is no drift: without an exact energy to compare, the run says change") {
  const std::string drop = "05_ball_collision --headless --duration 0.1 --set scene=drop ";
  CHECK(contains(run_program(drop + "--set count=30").err, " energy_change="));
  CHECK(contains(run_program("05_ball_collision --headless --duration 0.1").err, " energy_drift="));
  CHECK(contains(run_program("03_damping --headless --duration 1").err, " energy_drift="));
}

TEST_CASE("every run ends with one summary line on standard error") {
  const Outcome run = run_program("03_damping --headless");
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  REQUIRE(lines(run.err).size() == 1);
  for (const std::string field :
       {"method=semi-implicit-euler", "dt=0.001", "simulated_s=10", "wall_s=", "steps=10000",
        "force_evaluations=10000",
        "ns_per_step=", "energy_drift=", "position_error_m=", "velocity_error_m_per_s="}) {
    CAPTURE(field);
    CHECK(contains(run.err, field));
  }
  CHECK(contains(run_program("03_damping --headless --method rk4").err, "force_evaluations=40000"));
}

TEST_CASE("a run that was saved and goes on gives the same bits as one that never stopped") {
  for (const std::string method :
       {"explicit-euler", "semi-implicit-euler", "velocity-verlet", "rk4", "reference", "exact"}) {
    // 0.4371 s is in the middle of a contact (and of a step of dt = 0.0007).
    for (const std::string stop : {"0.43", "0.4371", "1"}) {
      const std::string setting = "03_damping --headless --dt 0.0007 --method " + method;
      CAPTURE(setting);
      CAPTURE(stop);
      const std::string state =
          (std::filesystem::temp_directory_path() / "bounce_saved_state").string();
      REQUIRE(run_program(setting + " --duration " + stop + " --save " + state).code == 0);
      const Outcome later = run_program("03_damping --load " + state + " --csv - --at 2,3");
      CHECK(later.code == 0);
      // The run without a stop cuts the same step, at the same time.
      const auto whole = lines(run_program(setting + " --csv - --at " + stop + ",2,3").out);
      const auto rest = lines(later.out);
      REQUIRE(rest.size() == 3);
      REQUIRE(whole.size() == 4);
      CHECK(rest[1] == whole[2]);
      CHECK(rest[2] == whole[3]);
      std::filesystem::remove(state);
    }
  }
}

TEST_CASE("--list names methods and parameters, and what is valid") {
  for (const std::string& stage : stages) {
    const Outcome run = run_program(stage + " --list");
    CHECK(run.code == 0);
    for (const std::string word :
         {"semi-implicit-euler", "exact", "mass", "gravity", "9.81", "m/s^2"}) {
      CHECK(contains(run.out, word));
    }
  }
  CHECK(contains(run_program("03_damping --list").out, "may-pull or push-only"));
  CHECK(contains(run_program("03_damping --list --set mass=7").out, "mass       kg     1 "));
}

TEST_CASE("--dt auto takes a step that suits the contact") {
  const Outcome soft = run_program("02_spring_floor --headless --dt auto --set stiffness=100");
  CHECK(contains(soft.err, "dt=0.01 "));
  const Outcome hard = run_program("02_spring_floor --headless --dt auto --set stiffness=1e6");
  CHECK(contains(hard.err, "dt=1e-04 "));
}

TEST_CASE("a step that is too long for the contact is named before the run") {
  const Outcome run = run_program("02_spring_floor --headless --dt 0.03 --duration 0.1");
  CHECK(contains(run.err, "warning: dt = 0.03 s is too large"));
  CHECK(run_program("02_spring_floor --headless --dt 0.001").err.find("warning") ==
        std::string::npos);
}

TEST_CASE("an interrupted run keeps what was computed, and ends with exit code 130" *
          doctest::skip(test::on_windows)) {
  // 1e11 steps would take minutes; Ctrl-C comes after half a second.
  const Outcome run = test::run_program_with(
      "timeout --preserve-status -s INT 0.5",
      "03_damping --headless --dt 1e-9 --duration 100 --csv out.csv --sample 1e-3 --save state");
  CAPTURE(run.err);
  CHECK(run.code == 130);
  CHECK(contains(run.err, "interrupted at t = "));
  CHECK(lines(test::read_file(test::work_folder() + "/out.csv")).size() > 2);
  CHECK(files() == std::vector<std::string>{"out.csv", "state"});
}

TEST_CASE("exact: a start on the touch gives a few rows, not the same one without end") {
  for (const std::string start :
       {"02_spring_floor --set position=0.1 --set velocity=-1", "03_damping --set position=0.1",
        "04_three_dimensions --set position=0,0.1,0",
        "06_oscillating_floor --set position=0.1 --set amplitude=0",
        "03_damping --set position=0.1 --set gravity=0"}) {
    const Outcome run =
        test::run_program_with("timeout 10", start + " --method exact --csv - --duration 0.02");
    CAPTURE(start);
    CHECK(run.code == 0);
    CHECK(lines(run.out).size() >= 3);
    CHECK(lines(run.out).size() < 10);
  }
}

TEST_CASE("a step that is longer than the run is shortened to its end") {
  const Outcome run = run_program("01_free_fall --dt 1e10 --csv - --at 1 --duration 5");
  CHECK(lines(run.out).back() == "1,-4.8100000000000005,-9.81");  // one step of 1 s
  CHECK(contains(run.err, "steps=2"));
}

TEST_CASE("exact does not look at the time step") {
  const Outcome run =
      test::run_program_with("timeout 10", "03_damping --headless --method exact --dt 1e-15");
  CHECK(run.code == 0);
  CHECK(contains(run.err, "simulated_s=10"));
}

TEST_CASE("a run whose exact solution has a billion events ends without the comparison") {
  const Outcome run =
      test::run_program_with("timeout 20", "02_spring_floor --headless --dt 1000 --duration 3e9");
  CHECK(run.code == 0);
  CHECK(!contains(run.err, "position_error"));
}

TEST_CASE("a file's name may have blanks and letters of any language, and the file is replaced") {
  const std::string name = std::filesystem::temp_directory_path().string() + "/Bälle, die 弾む";
  for (const std::string time : {"0.5", "1"}) {
    const Outcome run =
        run_program("03_damping --headless --at " + time + " --csv " + test::quoted(name + ".csv"));
    INFO(run.err);
    CHECK(run.code == 0);
    CHECK(contains(test::read_file(name + ".csv"), "\n" + time + ","));
  }
}
