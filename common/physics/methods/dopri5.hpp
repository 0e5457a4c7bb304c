#pragma once
#include <cstddef>

#include "physics/methods/embedded_pair.hpp"
#include "physics/state.hpp"

namespace bounce {

/// A Runge-Kutta method of order 5 that estimates its own error, with half the force evaluations of
/// `Dop853`: for steps that are short anyway. Its last slope is the one at the step's end.
/// Source: DOPRI5 of Dormand and Prince (1980), in Hairer, Norsett and Wanner, Solving Ordinary
/// Differential Equations I, 2nd edition (1993), table II.5.2.
template <class Vector>
class Dopri5 : public EmbeddedPair<Vector, 7> {
 public:
  /// A step of `h` from the start; it may be repeated with another `h`. The state holds until then.
  template <class Law>
  const State<Vector>& step(const Law& law, double t, double h);

  /// The error of the last step as it is estimated, in units of what `tolerance` allows. It is that
  /// of the result of order 4 to which the one of order 5 is compared.
  double error(double h, double tolerance) const {
    const auto difference = [](const Slopes& k) {
      return 71.0 / 57600 * k[1] + -71.0 / 16695 * k[3] + 71.0 / 1920 * k[4] +
             -17253.0 / 339200 * k[5] + 22.0 / 525 * k[6] + -1.0 / 40 * k[7];
    };
    const Vector v = difference(this->velocity_), a = difference(this->acceleration_);
    return this->in_units_allowed(h, tolerance, {v}, {a});
  }

  const Vector& acceleration_at_end() const { return this->acceleration_[7]; }

 private:
  using Slopes = typename EmbeddedPair<Vector, 7>::Slopes;
};

template <class Vector>
template <class Law>
const State<Vector>& Dopri5<Vector>::step(const Law& law, double t, double h) {
  const auto next = [&](std::size_t i, double c, const auto& sum) {
    this->slope(law, t, h, i, c, sum);
  };
  next(2, 1.0 / 5, [](const Slopes& k) { return 1.0 / 5 * k[1]; });
  next(3, 3.0 / 10, [](const Slopes& k) { return 3.0 / 40 * k[1] + 9.0 / 40 * k[2]; });
  next(4, 4.0 / 5,
       [](const Slopes& k) { return 44.0 / 45 * k[1] + -56.0 / 15 * k[2] + 32.0 / 9 * k[3]; });
  next(5, 8.0 / 9, [](const Slopes& k) {
    return 19372.0 / 6561 * k[1] + -25360.0 / 2187 * k[2] + 64448.0 / 6561 * k[3] +
           -212.0 / 729 * k[4];
  });
  next(6, 1, [](const Slopes& k) {
    return 9017.0 / 3168 * k[1] + -355.0 / 33 * k[2] + 46732.0 / 5247 * k[3] + 49.0 / 176 * k[4] +
           -5103.0 / 18656 * k[5];
  });
  next(7, 1, [](const Slopes& k) {
    return 35.0 / 384 * k[1] + 500.0 / 1113 * k[3] + 125.0 / 192 * k[4] + -2187.0 / 6784 * k[5] +
           11.0 / 84 * k[6];
  });
  this->state_.velocity = this->velocity_[7];
  return this->state_;
}

}  // namespace bounce
