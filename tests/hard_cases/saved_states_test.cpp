// Saved states that no run has written, and steps that no run can take.

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

#include "all_stages.hpp"
#include "run_program.hpp"
#include "sanitizers.hpp"

using namespace bounce;
using test::contains;
using test::run_program;

namespace {

/// What loading says to that memory; empty: it takes it.
std::string refusal(Simulation& simulation, const Simulation::Memory& memory) {
  try {
    simulation.recall(memory);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("hard case: a saved number beyond all reason is refused, with its name and range") {
  for (const test::Stage& stage : test::all_stages()) {
    for (const Method method : stage.make()->methods()) {
      std::unique_ptr<Simulation> simulation = stage.make();
      if (stage.name.name == "08_racket_game") stage.options[0].apply(simulation, "none");
      simulation->use_method(method);
      simulation->restart();
      simulation->advance_to(0.46);  // in contact, or just after it
      const Simulation::Memory good = simulation->memory();
      const std::string name = stage.name.name + " " + name_of(method);
      CAPTURE(name);
      CHECK(refusal(*simulation, good) == "");
      for (std::size_t i = 0; i < good.numbers.size(); ++i) {
        for (const double value : {1e308, -1e308, 1.1e100}) {
          Simulation::Memory bad = good;
          bad.numbers[i] = value;
          const std::string why = refusal(*simulation, bad);
          CAPTURE(why);
          CHECK(contains(why, "number " + std::to_string(i + 1) + " "));
          CHECK(contains(why, to_text(value)));
          CHECK(contains(why, "from -1e+100 to 1e+100"));
        }
      }
    }
  }
}

TEST_CASE("hard case: a saved clock out of range is refused, with its name and range") {
  const std::unique_ptr<Simulation> simulation = test::all_stages()[2].make();
  simulation->restart();
  simulation->advance_to(0.46);
  const Simulation::Memory good = simulation->memory();
  const auto refused = [&](auto change, const std::string& name) {
    for (const double value : {1e308, -1.0, 1e19}) {
      Simulation::Memory bad = good;
      change(bad, value);
      const std::string why = refusal(*simulation, bad);
      CAPTURE(why);
      CAPTURE(value);
      CHECK(contains(why, name));
      CHECK(contains(why, to_text(value)));
      CHECK(contains(why, "must be from"));
    }
  };
  refused([](Simulation::Memory& m, double value) { m.dt = value; }, "dt");
  refused([](Simulation::Memory& m, double value) { m.time = value; }, "time");
  refused([](Simulation::Memory& m, double value) { m.tolerance = value; }, "tolerance");
  refused([](Simulation::Memory& m, double value) { m.grid_start = value; }, "grid_start");
  refused([](Simulation::Memory& m, double value) { m.into_step = value; }, "into_step");
  Simulation::Memory other_time = good;
  other_time.time = 0.5;
  CHECK(contains(refusal(*simulation, other_time), "its time is 0.5"));
}

TEST_CASE("hard case: a step of the racket that needs millions of pieces ends, and says why") {
  // Numbers so far apart that one step would take years, in contact, in flight beside the disc, or
  // in the game; and bounces so short that 10 s have 1e15 of them.
  std::vector<std::string> settings{
      "--player none --dt 1e10 --duration 1e11", "--player autopilot --dt 1e10 --duration 1e11",
      "--player none --set mass=1e-30 --set stiffness=1e30 --set position=0,0.05,0",
      "--player none --set gravity=1e30",
      "--player none --set velocity=1e15,0,0 --set position=0,0.10000001,0 "
      "--set racket_radius=1e30"};
  if (test::is_sanitized) settings.resize(2);  // ten million pieces take the others 5 to 15 s
  for (const std::string& setting : settings) {
    const test::Outcome run = run_program("08_racket_game --headless " + setting);
    CAPTURE(setting);
    CAPTURE(run.err);
    CHECK(run.code == 3);
    CHECK(contains(run.err, "shorter --dt"));
  }
}
