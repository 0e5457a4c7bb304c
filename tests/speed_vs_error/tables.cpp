#include "speed_vs_error/tables.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace bounce::report {
namespace {

std::string text_of(double value, int digits = 2) {
  if (std::isnan(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  // 5840 to two digits is 5800, and not 5.8e+03.
  const double rounded = std::strtod(text, nullptr);
  if (std::abs(rounded) >= 10 && std::abs(rounded) < 1e6) {
    std::snprintf(text, sizeof text, "%.*f", rounded < std::pow(10, digits - 1) ? 1 : 0, rounded);
  }
  return text;
}

/// Of one method, the cheapest result that reaches the error together with all finer ones: a lucky
/// step does not count. Null when there is none.
const Result* cheapest(const std::vector<Result>& results, double error) {
  const Result* best = nullptr;
  for (const Result& r : results) {  // from coarse to fine
    if (!(r.position_error <= error)) {
      best = nullptr;
    } else if (best == nullptr || r.cost < best->cost) {
      best = &r;
    }
  }
  return best;
}

/// The smallest error that a method reaches at all.
const Result* most_accurate(const std::vector<Result>& results) {
  const Result* best = nullptr;
  for (const Result& r : results) {
    if (best == nullptr || r.position_error < best->position_error) best = &r;
  }
  return best;
}

std::string cost_table(const Report& report, const std::string& case_name) {
  std::string out =
      "| method | 1e-3 m | 1e-6 m | 1e-9 m | smallest error: position, velocity, energy (cost) |\n"
      "|---|---|---|---|---|\n";
  for (const std::string& method : methods_in(report, case_name)) {
    const std::vector<Result> results = results_of(report, case_name, method);
    if (method == "exact") {
      const std::string cost = text_of(results[0].cost);
      const double error = results[0].position_error;
      out += "| `exact` | " + cost + " | " + cost + " | " + cost + " | " +
             (std::isnan(error) ? "rounding"
                                : text_of(error) + " m, " + text_of(results[0].velocity_error) +
                                      " m/s, rounding (" + cost + ")") +
             " |\n";
      continue;
    }
    const Result* best = most_accurate(results);
    if (std::isnan(best->position_error)) continue;
    out += results[0].is_peer ? "| " + method + " |" : "| `" + method + "` |";
    for (const double error : {1e-3, 1e-6, 1e-9}) {
      const Result* r = cheapest(results, error);
      const std::string knob =
          r == nullptr || r->knob.empty() ? "" : " (" + text_of(r->value) + ")";
      out += r == nullptr ? " - |" : " " + text_of(r->cost) + knob + " |";
    }
    out += " " + text_of(best->position_error) + " m, " + text_of(best->velocity_error) + " m/s, " +
           text_of(best->energy_drift) + " (" + text_of(best->cost) + ") |\n";
  }
  return out;
}

/// For a lesson: the course's methods only, and what each step buys.
std::string choice_table(const Report& report, const std::string& case_name) {
  std::string out =
      "| method | error with 1 ms, fitted [m] | to 1 mm: us (step) | to 1 um | to 1 nm | order |\n"
      "|---|---|---|---|---|---|\n";
  for (const std::string& method : methods_in(report, case_name)) {
    const std::vector<Result> results = results_of(report, case_name, method);
    const bool steps = results[0].knob == "dt" && !std::isnan(results[0].position_error);
    if (results[0].is_peer || (!steps && method != "exact" && method != "reference")) continue;
    out += "| `" + method + "` |";
    if (method == "exact") {
      const std::string cost = text_of(results[0].cost);
      out += " rounding | " + cost + " | " + cost + " | " + cost + " | - |\n";
      continue;
    }
    const ErrorLine line = error_line(results);
    double with_1_ms = line.with_1_ms;
    for (const Result& r : results) {  // where no line goes through, what one run says
      if (std::isnan(with_1_ms) && r.knob == "dt" && std::abs(r.value / 1e-3 - 1) < 1e-3)
        with_1_ms = r.position_error;
    }
    out += " " + text_of(with_1_ms) + " |";
    for (const double error : {1e-3, 1e-6, 1e-9}) {
      const Result* r = cheapest(results, error);
      out += r == nullptr ? " - |" : " " + text_of(r->cost) + " (" + text_of(r->value) + ") |";
    }
    out += " " + text_of(line.order) + " |\n";
  }
  return out;
}

/// What cutting the steps at the events buys: RK4 on the two bounces, without and with.
std::string events_table(const Report& report) {
  std::string out = "| RK4 | (a) undamped | (b) damped |\n|---|---|---|\n";
  struct Pair {
    Result without, with;  // the most accurate of all, and the best that takes less work
  };
  const auto best = [&report](const char* name) {
    const std::vector<Result> without = results_of(report, name, "rk4");
    const std::vector<Result> with = results_of(report, name, "rk4-events");
    Pair pair{*most_accurate(without), with.at(0)};
    for (const Result& r : with) {
      if (r.evaluations > pair.without.evaluations) continue;
      if (r.position_error < pair.with.position_error) pair.with = r;
    }
    return pair;
  };
  const Pair a = best("bounce"), b = best("damped");
  const auto row = [&out](const std::string& what, const std::string& in_a,
                          const std::string& in_b) {
    out += "| " + what + " | " + in_a + " | " + in_b + " |\n";
  };
  const auto text = [](const Result& r) {
    return text_of(r.position_error) + " m with " + text_of(r.value) + " s";
  };
  row("the best without located events", text(a.without), text(b.without));
  row("with located events", text(a.with), text(b.with));
  row("times more accurate", text_of(a.without.position_error / a.with.position_error),
      text_of(b.without.position_error / b.with.position_error));
  row("times fewer force evaluations", text_of(a.without.evaluations / a.with.evaluations),
      text_of(b.without.evaluations / b.with.evaluations));
  row("times less CPU time", text_of(a.without.cost / a.with.cost),
      text_of(b.without.cost / b.with.cost));
  return out;
}

std::string order_table(const Report& report) {
  const std::vector<std::string> in{"fall", "bounce", "damped", "space", "shaken", "tilted"};
  std::string out = "| method |", line = "|---|";
  for (const std::string& name : in) out += " " + name + " |", line += "---|";
  out += "\n" + line + "\n";
  for (const char* method : {"explicit-euler", "semi-implicit-euler", "velocity-verlet", "rk4",
                             "rk4-events", "flight-rk4"}) {
    out += std::string("| `") + method + "` |";
    for (const std::string& name : in) {
      out += " " + text_of(error_line(results_of(report, name, method)).order) + " |";
    }
    out += "\n";
  }
  return out;
}

double cost_at(const Report& report, const std::string& case_name, const std::string& method,
               double dt) {
  for (const Result& r : results_of(report, case_name, method)) {
    if (std::abs(r.value / dt - 1) < 1e-3) return r.cost;
  }
  throw std::runtime_error("no " + method + " with this dt in " + case_name);
}

/// "1/60" for 0.01667, as game programmers say it.
std::string step_text(double dt) {
  const long per_second = std::lround(1 / dt);
  return per_second < 1000 ? "1/" + std::to_string(per_second) : text_of(dt);
}

std::string engine_table(const Report& report) {
  std::string out =
      "| | step [s] | us per s | largest error [m] | six heights | time of the sixth [s] |\n"
      "|---|---|---|---|---|---|\n";
  for (const std::string& method : methods_in(report, "engines")) {
    for (const Result& r : results_of(report, "engines", method)) {
      const bool shown = r.knob.empty() || r.value > 0.004 || r.value < 1.1e-4;
      if (!shown) continue;
      const bool lies = std::isinf(r.top_error);  // fewer than six bounces
      out += "| " + (r.is_peer ? method : "`" + method + "`") + " | " +
             (r.knob.empty() ? "none" : step_text(r.value)) + " | " + text_of(r.cost) + " | " +
             text_of(r.position_error) + " | " + (lies ? "-" : text_of(r.top_error * 100) + " %") +
             " | " + (lies ? "-" : text_of(r.top_time_error)) + " |\n";
    }
  }
  return out;
}

std::string model_table(const Report& report) {
  const double dt = 1e-4;
  const double bare = cost_at(report, "damped", "bare loop", dt);
  std::string out = "| the same steps | ns a step | ratio |\n|---|---|---|\n";
  const auto row = [&](const std::string& what, double cost) {
    out += "| " + what + " | " + text_of(cost * dt * 1e3, 3) + " | " + text_of(cost / bare, 3) +
           " |\n";
  };
  const std::string method = "semi-implicit-euler";
  row("the slides' bare loop", bare);
  row("the library, one dimension (stage 3)", cost_at(report, "damped", method, dt));
  row("the library, three dimensions (stage 4)", cost_at(report, "space", method, dt));
  for (const std::string& engine : methods_in(report, "engines")) {
    const Result first = results_of(report, "engines", engine)[0];
    if (first.is_peer) row(engine, cost_at(report, "engines", engine, dt));
  }
  return out;
}

/// What a plane costs: the same steps on a level floor and on a tilted plane.
std::string plane_table(const Report& report) {
  const double dt = 1e-4;
  const std::string method = "semi-implicit-euler";
  const auto shown = [&](const char* name) {  // the share is that of the numbers that a reader sees
    return std::strtod(text_of(cost_at(report, name, method, dt) * dt * 1e3, 3).c_str(), nullptr);
  };
  const double level = shown("space"), tilted = shown("tilted");
  return "| | ns a step |\n|---|---|\n| a level floor (stage 4) | " + text_of(level, 3) +
         " |\n| a plane (stage 7) | " + text_of(tilted, 3) + " |\n| the plane costs more by | " +
         text_of(100 * (tilted / level - 1)) + " % |\n";
}

std::string headline_table(const Report& report) {
  std::string out = "| | (a) undamped, 10 s | (b) damped, 5 s |\n|---|---|---|\n";
  const auto both = [&](const std::string& what, const auto& cell) {
    out += "| " + what + " | " + cell("bounce") + " | " + cell("damped") + " |\n";
  };
  const auto exact = [&](const char* name) { return results_of(report, name, "exact")[0]; };
  both("`exact`: CPU time per simulated second",
       [&](const char* name) { return text_of(exact(name).cost) + " us"; });
  both("`exact` in a sweep of 1,024 balls: for each", [&](const char* name) {
    const std::vector<Result> sweep = results_of(report, name, "exact in lanes");
    return sweep.empty() ? std::string("-") : text_of(sweep[0].cost) + " us";
  });
  both("`exact`: error",
       [&](const char* name) { return text_of(exact(name).position_error) + " m"; });
  both("the most accurate peer: error (cost against `exact`)", [&](const char* name) {
    Result best{};
    best.position_error = INFINITY;
    for (const Result& r : report.results) {
      if (r.is_peer && r.case_name == name && r.position_error < best.position_error) best = r;
    }
    if (!best.is_peer) return std::string("not measured");
    return best.method + ", " + text_of(best.position_error) + " m (" +
           text_of(best.cost / exact(name).cost) + " times)";
  });
  both("`flight-rk4` at 1e-9 m", [&](const char* name) {
    const std::vector<Result> all = results_of(report, name, "flight-rk4");
    const Result* r = cheapest(all, 1e-9);
    return r == nullptr ? std::string("-") : text_of(r->cost) + " us";
  });
  both("the cheapest peer at 1e-9 m", [&](const char* name) {
    std::string cell = "-";
    double cost = INFINITY;
    for (const std::string& method : methods_in(report, name)) {
      const std::vector<Result> all = results_of(report, name, method);
      const Result* r = all[0].is_peer ? cheapest(all, 1e-9) : nullptr;
      if (r == nullptr || r->cost >= cost) continue;
      cost = r->cost;
      cell = method + ", " + text_of(cost) + " us";
    }
    return cell;
  });
  both("RK4 with dt = 1e-4 s: error without, and with located events", [&](const char* name) {
    std::string cell;
    for (const char* method : {"rk4", "rk4-events"}) {
      for (const Result& r : results_of(report, name, method)) {
        if (std::abs(r.value / 1e-4 - 1) < 1e-3) {
          cell += (cell.empty() ? "" : ", ") + text_of(r.position_error) + " m";
        }
      }
    }
    return cell;
  });
  return out;
}

std::string machine_table(const Report& report) {
  std::string out = "| | |\n|---|---|\n";
  for (const std::string& line : report.about) {
    const std::size_t colon = line.find(": ");
    out += "| " + line.substr(0, colon) + " | " + line.substr(colon + 2) + " |\n";
  }
  return out;
}

}  // namespace

std::string table(const Report& report, const std::string& name) {
  if (name == "machine") return machine_table(report);
  if (name == "headline") return headline_table(report);
  if (name == "orders") return order_table(report);
  if (name == "model") return model_table(report);
  if (name == "plane") return plane_table(report);
  if (name == "events") return events_table(report);
  if (name.rfind("choice ", 0) == 0) return choice_table(report, name.substr(7));
  if (name == "engines") return engine_table(report);
  if (name.rfind("cost ", 0) == 0) return cost_table(report, name.substr(5));
  throw std::runtime_error("there is no table " + name);
}

}  // namespace bounce::report
