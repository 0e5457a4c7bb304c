#include "checks/loop_measured.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "checks/judge.hpp"
#include "checks/judged_process.hpp"

namespace bounce::check {

namespace {

// y'' = -w^2 y - 2 z w y', from y = 1 at rest.
SmoothCase spring(const char* name, double w, double z) {
  const double u = w * std::sqrt(1 - z * z);
  return {name,
          {[=](double, double y, double v) { return -w * w * y - 2 * z * w * v; }, 0, 1, 0},
          8 / w,
          w,
          [=](double t) {
            const double fall = std::exp(-z * w * t), c = std::cos(u * t), s = std::sin(u * t);
            return Walked::Noted{fall * (c + z * w / u * s), -fall * w * w / u * s};
          }};
}

// y'' = -4 y + 3 cos 3t: the answer that swings with the force, and some of the spring's own swing.
SmoothCase driven() {
  const auto exact = [](double t) {
    return Walked::Noted{-0.6 * std::cos(3 * t) + std::sin(2 * t),
                         1.8 * std::sin(3 * t) + 2 * std::cos(2 * t)};
  };
  const double start = 0.3;
  return {"under a force that depends on the time",
          {[](double t, double y, double) { return -4 * y + 3 * std::cos(3 * t); }, start,
           exact(start).y, exact(start).v},
          3,
          3,
          exact};
}

// y'' = 2 y^3: y = 1 / (1 + t)
SmoothCase curved() {
  return {"under a force that is not in proportion to the place",
          {[](double, double y, double) { return 2 * y * y * y; }, 0, 1, -1},
          2,
          2,
          [](double t) {
            return Walked::Noted{1 / (1 + t), -1 / ((1 + t) * (1 + t))};
          }};
}

constexpr long looks = 8;  // at so many moments: at one alone, an error can be 0 by chance

double error(const SmoothCase& on, long steps) {
  Walk walk = on.walk;
  walk.steps = steps;
  walk.every = steps / looks;
  walk.dt = on.duration / static_cast<double>(steps);
  double squares = 0, t = walk.t;
  for (const Walked::Noted& got : subject().walk(walk).states) {
    t += on.duration / looks;
    const Walked::Noted right = on.exact(t);
    squares += std::pow(got.y - right.y, 2) + std::pow((got.v - right.v) / on.rate, 2);
  }
  return std::sqrt(squares / looks);
}

// A ball of 1 kg on a spring floor, or (`lets_go` is false) fixed to the spring.
constexpr double g = 9.81, k = 1e4, r = 0.1, rate = 100;  // m/s^2, N/m, m, 1/s

Energies energies(double v, bool lets_go, double duration) {
  const auto overlap = [=](double y) { return lets_go ? std::max(0.0, r - y) : r - y; };
  Walk walk{[=](double, double y, double) { return -g + k * overlap(y); }, 0, r, v, energy_dt};
  walk.steps = std::lround(duration / walk.dt);
  walk.every = 37;   // no whole part of a bounce
  begin_question();  // each of these long walks has a time of its own
  const std::vector<Walked::Noted> states = subject().walk(walk).states;
  const std::size_t late = states.size() - states.size() / 100;
  Energies all;
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double d = overlap(states[i].y);
    const double kinetic = states[i].v * states[i].v / 2;
    const double energy = (kinetic + g * (states[i].y - r) + k * d * d / 2) / (v * v / 2);
    if (!(energy < 1e3)) return {all.least, energy, energy};
    all.least = std::min(all.least, energy);
    all.most = std::max(all.most, energy);
    if (i >= late) sum += energy;
  }
  all.last = sum / static_cast<double>(states.size() - late);
  return all;
}

}  // namespace

const std::vector<SmoothCase>& undamped_cases() {
  static const std::vector<SmoothCase> all{spring("on a spring without a damper", 20, 0), driven(),
                                           curved()};
  return all;
}

const SmoothCase& damped_case() {
  static const SmoothCase one = spring("on a spring with a damper", 20, 0.2);
  return one;
}

double measured_order(const SmoothCase& on) {
  constexpr double rounding = 1e-12;
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const long part : {5, 6, 8, 10, 13, 16, 20, 26, 32, 40, 52, 64}) {
    const double off = error(on, looks * part);
    if (off < rounding) continue;
    const double log_dt = -std::log(static_cast<double>(part)), log_error = std::log(off);
    ++count;
    x += log_dt;
    y += log_error;
    xx += log_dt * log_dt;
    xy += log_dt * log_error;
  }
  if (count < 3) return std::numeric_limits<double>::infinity();
  return (count * xy - x * y) / (count * xx - x * x);
}

Energies energies_of_bounces() {
  Energies all;
  for (const double v : {0.5, 0.43, 0.61}) {  // m/s, with which it leaves the floor
    const double contact = (std::numbers::pi + 2 * std::atan(g / (rate * v))) / rate;
    const Energies one = energies(v, true, 1e4 * (2 * v / g + contact));
    all = {std::min(all.least, one.least), std::max(all.most, one.most), one.last};
    if (!(one.most < 1e3)) return one;
  }
  return all;
}

Energies energies_of_swings() { return energies(0.5, false, 1e4 * 2 * std::numbers::pi / rate); }

double evaluations_a_step() {
  Walk walk = undamped_cases()[0].walk;
  walk.dt = 1e-3;
  const auto count = [&](long steps) {
    walk.steps = steps;
    return static_cast<double>(subject().walk(walk).evaluations);
  };
  return (count(300) - count(100)) / 200;
}

}  // namespace bounce::check
