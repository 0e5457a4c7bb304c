#include "run/headless.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>

#include "run/interrupt.hpp"
#include "run/output_file.hpp"
#include "run/progress.hpp"
#include "run/save_load.hpp"
#include "run/step_warning.hpp"

namespace bounce {
namespace {

/// The trace: a header, then rows of `t` and the state in decimals that read back to the same bits.
class Trace {
 public:
  Trace(const std::string& path, const Simulation& simulation)
      : file_("--csv", path), columns_(simulation.columns()) {
    file_.write("t," + join(columns_, ",") + "\n");
  }
  void write(const Simulation& simulation) {
    rows_ += static_cast<double>(simulation.balls());
    if (rows_ > 1e8) {  // known beforehand for steps, but not for events
      throw BadInput("--csv has got 1e8 rows, and more are not allowed: give --sample or --at");
    }
    const std::vector<double> values = simulation.values();
    std::string rows;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % columns_.size() == 0) rows += to_text(simulation.time());
      rows += ',';
      rows += to_text(values[i]);
      if ((i + 1) % columns_.size() == 0) rows += "\n";
    }
    file_.write(rows);
  }
  void finish() { file_.finish(); }

 private:
  OutputFile file_;
  std::vector<std::string> columns_;
  double rows_ = 0;
};

/// The times of the trace rows: those of --at, or every --sample, or every step (event, for
/// methods that go by events).
class RowTimes {
 public:
  RowTimes(const Options& options, double start) : options_(options) {
    if (options.sample <= 0) return;
    n_ = static_cast<std::size_t>(std::ceil(start / options.sample));
    a_second_ = std::round(1 / options.sample);
  }

  /// The next one [s], not before the simulation's time; nothing when there are no more.
  std::optional<double> next(const Simulation& simulation) {
    const double end = options_.duration;
    if (!options_.at.empty()) {
      if (n_ == options_.at.size()) return std::nullopt;
      return options_.at[n_++];
    }
    if (options_.sample > 0) {
      const auto n = static_cast<double>(n_++);
      // The third tenth of a second is 3 / 10 = 0.3, and 3 * 0.1 is 0.30000000000000004.
      const double t = a_second_ * options_.sample == 1 ? n / a_second_ : n * options_.sample;
      if (t > end + 1e-9 * options_.sample) return std::nullopt;
      return std::min(t, end);
    }
    if (n_++ == 0) return simulation.time();
    if (simulation.time() >= end) return std::nullopt;
    if (simulation.method().goes_by_events) return std::min(simulation.next_event(), end);
    const double t = simulation.time_of_next_step();
    return t > end - 1e-6 * simulation.dt() ? end : t;
  }

 private:
  const Options& options_;
  double a_second_ = 0;  // rows, where that is a whole number
  std::size_t n_ = 0;
};

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// "name=value" pairs in one line, for people and for programs.
std::string summary(const StageName& stage, Simulation& simulation, double start, double wall,
                    double stepping, double energy_at_start, long long steps_at_start) {
  std::string line = stage.name + ": method=" + name_of(simulation.method());
  const auto say = [&line](const std::string& name, double value) {
    if (!std::isfinite(value)) return;  // beyond what a double can hold: better no number
    line += " " + name + "=" + to_rounded_text(value, 4);
  };
  const long long steps = simulation.steps() - steps_at_start;
  if (!simulation.method().goes_by_events) line += " dt=" + to_text(simulation.dt());
  if (simulation.method() == methods::reference) {
    line += " tolerance=" + to_text(simulation.tolerance());
  }
  say("simulated_s", simulation.time() - start);
  say("wall_s", wall);
  line += " steps=" + std::to_string(steps);
  const int each = simulation.method().evaluations;
  const long long evaluations = steps * each + simulation.counted_force_evaluations();
  line += " force_evaluations=" + std::to_string(evaluations);
  if (steps > 0) {
    const double ns = stepping / static_cast<double>(steps) * 1e9;
    say("ns_per_step", ns);
    const auto balls = static_cast<double>(simulation.balls());
    if (balls > 1) say("ns_per_step_and_ball", ns / balls);
  }
  // Against the exact solution's energy, so that what the damper takes is no drift. Where there is
  // none, what changed is both: what dampers took, and what the method lost or gained.
  const std::optional<double> exact = simulation.energy_account().exact;
  const std::vector<Parameter> all = simulation.parameters();
  const bool is_damped = std::any_of(all.begin(), all.end(), [](const Parameter& parameter) {
    return parameter.name.find("damping") != std::string::npos && parameter.text() != "0";
  });
  const double scale = std::abs(energy_at_start) > 0 ? std::abs(energy_at_start) : 1;
  say(exact || !is_damped ? "energy_drift" : "energy_change",
      (simulation.energy().total() - exact.value_or(energy_at_start)) / scale);
  if (const std::optional<StateError> error = simulation.error()) {
    say("position_error_m", error->position);
    say("velocity_error_m_per_s", error->velocity);
    const std::string truth(simulation.traits().truth);
    if (truth != "exact") line += " compared_with=\"" + truth + "\"";
  }
  const std::string more = simulation.traits().summary;
  if (!more.empty()) line += " " + more;
  return interrupted() ? line + " interrupted=yes" : line;
}

}  // namespace

int run_headless(const StageName& stage, Simulation& simulation, const Options& options) {
  std::optional<Trace> trace;
  if (!options.csv.empty()) trace.emplace(options.csv, simulation);
  if (!options.save.empty()) OutputFile::check("--save", options.save);
  if (const std::string warning = step_warning(simulation); !warning.empty()) {
    std::cerr << stage.name << ": warning: " << warning << "\n";
  }
  catch_interrupts();

  const double start = simulation.time();
  const double energy_at_start = simulation.energy().total();
  const long long steps_at_start = simulation.steps();
  const Clock::time_point begin = Clock::now();
  double stepping = 0;
  std::optional<ProgressLine> bar(std::in_place, simulation, options.duration, options.csv == "-");
  const auto advance = [&](double t) {
    const Clock::time_point now = Clock::now();
    while (!interrupted() && !simulation.advance_some(t)) bar->show(simulation);
    bar->show(simulation);
    stepping += seconds_since(now);
  };

  try {
    if (trace) {
      RowTimes rows(options, start);
      for (auto t = rows.next(simulation); t && !interrupted(); t = rows.next(simulation)) {
        advance(*t);
        if (simulation.time() == *t) trace->write(simulation);
      }
    }
    advance(options.duration);
  } catch (const MachineFailure&) {
    throw;
  } catch (const BadInput&) {
    throw;
  } catch (...) {
    if (trace) trace->finish();  // the rows up to the last good state tell what happened
    throw;
  }
  bar.reset();  // gone before anything else is said
  if (trace) trace->finish();
  if (!options.save.empty()) save_state(options.save, stage, simulation);
  std::cerr << summary(stage, simulation, start, seconds_since(begin), stepping, energy_at_start,
                       steps_at_start)
            << "\n";
  if (!interrupted()) return exit_ok;
  std::cerr << stage.name << ": interrupted at t = " << to_rounded_text(simulation.time(), 6)
            << " s; what was computed until then is kept\n";
  return exit_interrupted;
}

int guarded(const StageName& stage, const Simulation& simulation,
            const std::function<int()>& work) {
  const auto say = [&](const std::string& sentence) {
    std::cerr << stage.name << ": " << sentence << "\n";
  };
  try {
    return work();
  } catch (const BadInput& error) {
    say(error.what());
    return exit_input;
  } catch (const MachineFailure& error) {
    say(error.what());
    return exit_machine;
  } catch (const NonFinite& error) {
    const std::string advice = step_warning(simulation);
    say("the state became non-finite after t = " + to_rounded_text(error.t, 6) + " s" +
        (advice.empty() ? std::string(": the parameters leave the range of double precision")
                        : ": " + advice));
    return exit_physics;
  } catch (const TimeStandsStill& error) {
    say(std::string(error.what()) + " at t = " + to_rounded_text(error.t, 6) +
        " s: " + error.advice);
    return exit_physics;
  } catch (const std::exception& error) {
    say(std::string("stopped: ") + error.what());
    return exit_machine;
  }
}

}  // namespace bounce
