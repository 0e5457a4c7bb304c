// Boost.Odeint on the same work: classical Runge-Kutta with fixed steps, and Dormand-Prince 5 under
// error control, once as it is, and once stopped at each touch and lift-off.

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "speed_vs_error/subjects.hpp"

namespace bounce::report {
namespace {

namespace odeint = boost::numeric::odeint;
using Y = std::array<double, 2>;  // height, velocity

struct Ball {  // m = 1, r = 0.1, g = 9.81, k = 1e4
  double c;
  long long* calls;
  void operator()(const Y& y, Y& rate, double /*t*/) const {
    ++*calls;
    rate = {y[1], -9.81 + (y[0] < 0.1 ? 1e4 * (0.1 - y[0]) - c * y[1] : 0)};
  }
};

// The law of one phase, smooth across its end.
struct Phase {
  double c;
  bool touch;
  long long* calls;
  void operator()(const Y& y, Y& rate, double /*t*/) const {
    ++*calls;
    rate = {y[1], -9.81 + (touch ? 1e4 * (0.1 - y[0]) - c * y[1] : 0)};
  }
};

Subject subject_of(const std::string& method, const std::string& knob, double value, double t_end,
                   std::function<std::vector<Row>(const std::vector<double>&, long long*)> work) {
  Subject subject{method, knob, value, true, {}, {}};
  subject.sample = [work](const std::vector<double>& times) {
    long long calls = 0;
    return work(times, &calls);
  };
  subject.run = [work, t_end] {
    long long calls = 0;
    return work({t_end}, &calls).back()[0];
  };
  subject.evaluations = [work, t_end] {
    long long calls = 0;
    work({t_end}, &calls);
    return calls;
  };
  return subject;
}

std::vector<Row> fixed_steps(double c, double dt, const std::vector<double>& times,
                             long long* calls) {
  odeint::runge_kutta4<Y> stepper;
  std::vector<Row> rows;
  Y y{1, 0};
  double t = 0;
  for (const double until : times) {
    while (until - t > 1e-9 * dt) {
      const double h = std::min(dt, until - t);
      stepper.do_step(Ball{c, calls}, y, t, h);
      t += h;
    }
    t = until;
    rows.push_back({y[0], y[1]});
  }
  return rows;
}

std::vector<Row> controlled(double c, double tolerance, const std::vector<double>& times,
                            long long* calls) {
  auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<Y>());
  std::vector<Row> rows;
  Y y{1, 0};
  double t = 0, dt = 1e-4;
  for (const double until : times) {
    while (t < until) {
      const double wished = dt;
      const bool last = t + dt >= until;
      if (last) dt = until - t;
      const auto result = stepper.try_step(Ball{c, calls}, y, t, dt);
      if (last && result == odeint::success) {
        t = until;
        dt = std::max(dt, wished);
      }
    }
    rows.push_back({y[0], y[1]});
  }
  return rows;
}

// Dense output: the step runs past the event, which is then found on the interpolant.
std::vector<Row> with_events(double c, double tolerance, const std::vector<double>& times,
                             long long* calls) {
  auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<Y>());
  std::vector<Row> rows;
  Y y{1, 0};
  bool touch = false;
  stepper.initialize(y, 0, 1e-3);
  std::size_t next = 0;
  while (next < times.size()) {
    stepper.do_step(Phase{c, touch, calls});
    const auto gap = [&](double t) {
      stepper.calc_state(t, y);
      return touch ? 0.1 - y[0] : y[0] - 0.1;
    };
    double event = stepper.current_time();
    const bool crossed = gap(event) < 0;
    if (crossed) {
      double low = stepper.previous_time(), high = event;
      for (int i = 0; i < 60 && high - low > 1e-16 * high; ++i) {  // Newton, kept in the bracket
        const double value = gap(event), slope = touch ? -y[1] : y[1];
        (value > 0 ? low : high) = event;
        const double newton = event - value / slope;
        const double better = newton > low && newton < high ? newton : (low + high) / 2;
        if (better == event) break;
        event = better;
      }
    }
    for (; next < times.size() && times[next] <= event; ++next) {
      stepper.calc_state(times[next], y);
      rows.push_back({y[0], y[1]});
    }
    if (crossed) {
      stepper.calc_state(event, y);
      y[0] = 0.1;
      touch = !touch;
      stepper.initialize(y, event, 1e-3);
    }
  }
  return rows;
}

}  // namespace

void add_odeint(Case& on, double damping) {
  for (const double dt : geometric(1e-2, 2e-6, 3)) {
    on.subjects.push_back(subject_of("Odeint rk4", "dt", dt, on.t_end, [=](auto& times, auto* n) {
      return fixed_steps(damping, dt, times, n);
    }));
  }
  for (const double tolerance : geometric(1e-3, 1e-13, 2)) {
    on.subjects.push_back(
        subject_of("Odeint dopri5", "tolerance", tolerance, on.t_end,
                   [=](auto& times, auto* n) { return controlled(damping, tolerance, times, n); }));
    on.subjects.push_back(subject_of(
        "Odeint dopri5 + events", "tolerance", tolerance, on.t_end,
        [=](auto& times, auto* n) { return with_events(damping, tolerance, times, n); }));
  }
}

}  // namespace bounce::report
