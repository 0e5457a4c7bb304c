// Cases of the stages that have a Simulation class of their own: many balls, and the racket. Truth
// is `exact`; where a stage has no formula, it is `reference` with a tolerance below those that are
// judged. It agrees with 40-digit values to 1e-13 (tests/stages/05_reference_test.cpp).

#include <memory>
#include <utility>

#include "05_ball_collision/run/balls_world.hpp"
#include "08_racket_game/run/command_line.hpp"
#include "speed_vs_error/subjects.hpp"

namespace bounce::report {
namespace {

/// What the simulation shows of all its balls now, and its energy at the end.
Row row_of(const Simulation& simulation) {
  const std::vector<std::string> columns = simulation.columns();
  const std::vector<double> values = simulation.values();
  Row row, velocities;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& name = columns[i % columns.size()];
    if (name[0] == 'v') velocities.push_back(values[i]);
    if (name == "x" || name == "y" || name == "z") row.push_back(values[i]);
  }
  row.insert(row.end(), velocities.begin(), velocities.end());
  row.push_back(simulation.energy().total());
  return row;
}

/// `knob` is the time step, or the tolerance of `reference`; `exact` has none.
Subject subject_of(const std::shared_ptr<Simulation>& run, Method method, double knob,
                   double t_end) {
  const char* name = method == methods::exact       ? ""
                     : method == methods::reference ? "tolerance"
                                                    : "dt";
  Subject subject{name_of(method), name, knob, false, {}, {}};
  const auto begin = [=] {
    run->use_method(method);
    if (method == methods::reference) run->use_tolerance(knob);
    if (!method.goes_by_events) run->use_dt(knob);
    run->restart();
  };
  subject.sample = [=](const std::vector<double>& times) {
    begin();
    std::vector<Row> rows;
    for (const double t : times) {
      try {
        run->advance_to(t);
      } catch (const NonFinite&) {  // too large a step: the rows end here
        break;
      }
      rows.push_back(row_of(*run));
    }
    return rows;
  };
  subject.run = [=] {
    begin();
    run->advance_to(t_end);
    return run->values()[1];
  };
  subject.evaluations = [=] {
    begin();
    run->advance_to(t_end);
    return run->steps() * method.evaluations + run->counted_force_evaluations();
  };
  return subject;
}

using Settings = std::vector<std::pair<const char*, const char*>>;

struct Truth {
  Method method;
  double tolerance;  // of `reference`; 0 for `exact`
  double finest;     // of the steps that are judged by it, s
};

void add_case(std::vector<Case>& all, const std::string& name, int stage, const std::string& what,
              double t_end, const Truth& truth, const std::shared_ptr<Simulation>& run,
              const Settings& settings) {
  for (const auto& [parameter, value] : settings) {
    const std::vector<Parameter> parameters = run->parameters();
    find_parameter(parameters, parameter).set(value);
  }
  run->restart();
  Case one{name, stage, what, t_end, {}, {}};
  for (int i = 1; i <= 100; ++i) one.times.push_back(t_end * i / 100);
  one.energy = [](double /*t*/, const Row& row) { return row.back(); };
  const Subject right = subject_of(run, truth.method, truth.tolerance, t_end);
  one.truth = right.sample(one.times);
  if (truth.method == methods::exact) one.subjects.push_back(right);
  for (const Method method : run->methods()) {
    if (method == methods::reference) {
      for (const double tolerance : geometric(1e-3, 1e-12, 1)) {
        one.subjects.push_back(subject_of(run, method, tolerance, t_end));
      }
    }
    if (method.evaluations == 0) continue;  // no step to choose
    for (const double dt : geometric(1e-2, truth.finest, 3)) {
      one.subjects.push_back(subject_of(run, method, dt, t_end));
    }
  }
  all.push_back(one);
}

}  // namespace

void add_simulated_cases(std::vector<Case>& all) {
  add_case(all, "pair", 5, "two balls that meet off centre, with a damper, 1 s", 1,
           {methods::reference, 1e-14, 1e-5}, std::make_shared<BallsRun>(),
           {{"gap", "0.08"}, {"damping", "5"}});
  add_case(all, "cradle", 5, "five balls in a row that all but touch, 2 s", 2,
           {methods::reference, 1e-14, 2e-5}, std::make_shared<BallsRun>(), {{"scene", "cradle"}});
  // No longer: a difference grows tenfold every 0.1 s there (lesson_numbers_05 growth).
  add_case(all, "heap", 5, "27 balls that fall into a tray, 0.6 s", 0.6,
           {methods::reference, 1e-14, 2e-5}, std::make_shared<BallsRun>(),
           {{"scene", "drop"}, {"count", "27"}});

  const auto racket = std::make_shared<BareRacketRun>();
  add_case(all, "racket", 8, "a ball over a racket that rises and moves aside, 2 s", 2,
           {methods::exact, 0, 2e-6}, racket,
           {{"racket_velocity", "0.2,0.5,0"}, {"velocity", "0.2,0,0"}});

  const auto rim = std::make_shared<BareRacketRun>();
  add_case(all, "rim", 8, "a ball on the rim of a racket that moves aside, 1 s", 1,
           {methods::reference, 1e-15, 2e-6}, rim,
           {{"racket_velocity", "0.2,0.5,0"}, {"position", "0.33,1,0.1"}});
}

}  // namespace bounce::report
