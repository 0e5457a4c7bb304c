#pragma once
#include <functional>
#include <string>
#include <vector>

#include "checks/subject.hpp"

namespace bounce::check {

/// A smooth law with a known answer.
struct SmoothCase {
  std::string name;  // "on a spring without a damper"
  Walk walk;         // law and start; dt and steps are chosen
  double duration;   // s
  double rate;       // 1/s: by how much a velocity is divided to be compared with a position
  std::function<Walked::Noted(double)> exact;  // at the time t
};
const std::vector<SmoothCase>& undamped_cases();
const SmoothCase& damped_case();

/// The order of the subject's method there: the slope of error against dt, both as logarithms, by
/// least squares over twelve steps from coarse to fine. Errors that are rounding only do not count;
/// infinite where hardly any other is left.
double measured_order(const SmoothCase& on);

/// The energy of a ball without a damper, as multiples of that at the start.
struct Energies {
  double least = 1, most = 1;
  double last = 1;  // the mean of the last hundredth
};
inline constexpr double energy_dt = 4e-4;  // s; 1/25 of the spring's own time, sqrt(m / k)
/// For as long as 10 000 bounces on a spring floor take, from three heights: the ends of all three.
Energies energies_of_bounces();
/// For 10 000 swings on that spring, which never lets go.
Energies energies_of_swings();

/// Of the force, a step, once the method is under way.
double evaluations_a_step();

}  // namespace bounce::check
