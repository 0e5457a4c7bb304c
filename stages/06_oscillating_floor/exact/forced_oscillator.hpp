#pragma once
#include <cmath>
#include <complex>

#include "physics/events/closed_form.hpp"

namespace bounce {

using Complex = std::complex<double>;

/// A damped oscillator that is shaken: x'' + 2 beta x' + omega0^2 x = Im(push e^(i w t)).
/// Its movement is the free one from its start, plus the one that the shaking makes from rest:
///
///   z(t) = Im( push * E[i w, p, q] ),   p, q = -beta +- sqrt(beta^2 - omega0^2)
///
/// where E is the divided difference of s -> e^(s t): E[a, b] = (e^(a t) - e^(b t)) / (a - b), and
/// E[a, b, c] = (E[a, b] - E[b, c]) / (a - c). At resonance, w = omega0 without a damper, a and b
/// meet, and the difference quotient becomes a derivative: nothing is divided by zero.
class ForcedOscillator {
 public:
  ForcedOscillator(double omega0, double beta, double w)  // [rad/s], [1/s], [rad/s]
      : free_(omega0, beta), omega0_squared_(omega0 * omega0), beta_(beta), i_w_(0, w) {
    const double discriminant = (omega0 - beta) * (omega0 + beta);
    const double root = std::sqrt(std::abs(discriminant));
    if (discriminant > 0) {
      near_ = {-beta, root};
      far_ = {-beta, -root};
    } else {
      far_ = -(beta + root);
      near_ = omega0_squared_ / far_.real();  // -beta + root, without the cancellation
    }
    to_far_ = 1.0 / (i_w_ - far_);
  }

  /// Position [m] and velocity [m/s] after `t` seconds. `push` [m/s^2] as of the start, and `turn`
  /// is e^(i w t), which the caller has at hand.
  State<double> move(const State<double>& start, Complex push, double t, Complex turn) const {
    const State<double> kick = free_.move({0, 1}, t);  // E[p, q], and its derivative
    const double x = start.position * (kick.velocity + 2 * beta_ * kick.position) +
                     start.velocity * kick.position;
    const double v =
        start.velocity * kick.velocity - omega0_squared_ * start.position * kick.position;

    const Complex e_near = kick.velocity - far_ * kick.position;  // e^(p t)
    const Complex first = divided_difference(turn, e_near, t);    // E[i w, p]
    const Complex z = push * to_far_ * (first - kick.position);
    const Complex z_rate = push * to_far_ * (turn + near_ * first - kick.velocity);
    return {x + z.imag(), v + z_rate.imag()};
  }

 private:
  // (e^(i w t) - e^(p t)) / (i w - p); for a small difference, where that cancels, in the form
  // t e^(mean t) sinh(d) / d with d = (i w - p) t / 2.
  Complex divided_difference(Complex turn, Complex e_near, double t) const {
    const Complex d = (i_w_ - near_) * (t / 2);
    const double size = std::norm(d);
    if (size > 0.25) return (turn - e_near) / (i_w_ - near_);
    const Complex ratio = size < 1e-10 ? 1.0 + d * d / 6.0 : std::sinh(d) / d;
    return t * std::exp((i_w_ + near_) * (t / 2)) * ratio;
  }

  DampedOscillator free_;
  double omega0_squared_;
  double beta_;
  Complex i_w_;
  Complex near_;    // p: the root that i w can meet
  Complex far_;     // q
  Complex to_far_;  // 1 / (i w - q)
};

}  // namespace bounce
