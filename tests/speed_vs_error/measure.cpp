#include "speed_vs_error/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "physics/reference_values.hpp"
#include "speed_vs_error/engines.hpp"
#include "speed_vs_error/stopwatch.hpp"

namespace bounce::report {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double distance(const Row& a, const Row& b, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The errors of one subject: maxima over the case's times.
Result errors_of(const Case& on, const Subject& subject) {
  Result result{on.name,         on.stage, subject.method, subject.knob, subject.value,
                subject.is_peer, nothing,  nothing,        nothing,      nothing,
                nothing,         nothing,  nothing};
  if (subject.judge) {
    subject.judge(result);
  } else if (subject.sample && subject.method != "exact") {
    const std::vector<Row> rows = subject.sample(on.times);
    result.position_error = result.velocity_error = result.energy_drift = 0;
    const double energy = std::abs(on.energy(on.times[0], on.truth[0]));
    const std::size_t half = on.truth[0].size() / 2, all = 2 * half;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto keep_larger = [](double& worst, double value) {
        if (!(value <= worst)) worst = value;  // also when it is not a number
      };
      keep_larger(result.position_error, distance(rows[i], on.truth[i], 0, half));
      keep_larger(result.velocity_error, distance(rows[i], on.truth[i], half, all));
      const double t = on.times[i];
      keep_larger(result.energy_drift,
                  std::abs(on.energy(t, rows[i]) - on.energy(t, on.truth[i])) / energy);
    }
    if (rows.size() < on.times.size()) result.position_error = result.velocity_error = INFINITY;
  }
  const long long calls = subject.evaluations ? subject.evaluations() : 0;
  result.evaluations = static_cast<double>(calls) / on.t_end;
  return result;
}

/// What `exact` itself is wrong by: against answers with 50 digits, where there are some.
void judge_exact(const Case& on, const Subject& exact, Result& result) {
  const bool undamped = on.name == "bounce";
  if (!undamped && on.name != "damped") return;
  result.position_error = result.velocity_error = 0;
  for (const test::ReferenceValue& r : test::reference_values) {
    const bool same = r.mass == 1 && r.stiffness == 1e4 && r.damping == (undamped ? 0 : 5) &&
                      r.law == ContactLaw::may_pull;
    if (!same) continue;
    const Row row = exact.sample({r.t})[0];
    result.position_error = std::max(result.position_error, std::abs(row[0] - r.y));
    result.velocity_error = std::max(result.velocity_error, std::abs(row[1] - r.v));
  }
}

std::vector<std::string> about_this_run() {
  char date[16];
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return {"processor: " + processor(),           std::string("compiler: ") + BOUNCE_COMPILER,
          std::string("flags: ") + BOUNCE_FLAGS, std::string("peers: ") + BOUNCE_PEERS,
          "engines: " + engine_versions(),       std::string("date: ") + date};
}

std::vector<Case> all_cases() {
  std::vector<Case> all = cases();
  for (Case& on : all) {
    if (on.name != "bounce" && on.name != "damped") continue;
    add_odeint(on, on.name == "damped" ? 5 : 0);
    add_cvode(on, on.name == "damped" ? 5 : 0);
  }
  all.push_back(engines_case());
  add_simulated_cases(all);
  return all;
}

}  // namespace

Report measure(const std::vector<std::string>& wanted) {
  Report report{about_this_run(), {}};
  const std::vector<Case> all = all_cases();
  for (const std::string& name : wanted) {
    const auto has_name = [&](const Case& on) { return on.name == name; };
    if (std::none_of(all.begin(), all.end(), has_name)) {
      throw std::runtime_error("there is no case '" + name + "'");
    }
  }
  for (const Case& on : all) {
    const bool is_wanted = std::find(wanted.begin(), wanted.end(), on.name) != wanted.end();
    if (!wanted.empty() && !is_wanted) continue;
    std::fprintf(stderr, "%s: %zu runs, errors", on.name.c_str(), on.subjects.size());
    std::vector<Result> results;
    std::vector<Work> works;
    for (const Subject& subject : on.subjects) {
      results.push_back(errors_of(on, subject));
      if (subject.method == "exact") judge_exact(on, subject, results.back());
      works.push_back([&subject](long n) {
        double sum = 0;
        for (long i = 0; i < n; ++i) sum += subject.run();
        return sum;
      });
    }
    std::fprintf(stderr, ", costs\n");
    const std::vector<double> cost = cost_in_alternation(works, 5, 0.01);
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i].cost = cost[i] / on.t_end / on.subjects[i].balls * 1e6;
      report.results.push_back(results[i]);
    }
  }
  return report;
}

}  // namespace bounce::report
