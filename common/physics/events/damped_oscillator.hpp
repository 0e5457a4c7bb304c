#pragma once
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/state.hpp"

namespace bounce {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// A moment [s] (`never` when it does not come) and the velocity then [m/s].
struct Crossing {
  double t;
  double velocity;
};

/// The damped oscillator x'' + 2 beta x' + omega0^2 x = 0, solved by formula in all three regimes.
/// With the discriminant D = omega0^2 - beta^2 and its root w = sqrt(|D|):
///   under-damped  (D > 0)  cosine and sine of w t under the envelope exp(-beta t)
///   over-damped   (D < 0)  two exponentials with the rates beta - w and beta + w
///   critical      (D = 0)  the common limit of both: exp(-beta t) times a straight line.
/// The formulas are written so that nothing cancels near D = 0 nor for a very strong damper.
class DampedOscillator {
 public:
  DampedOscillator(double omega0, double beta)  // [rad/s], [1/s]
      : omega0_(omega0),
        omega0_squared_(omega0 * omega0),
        beta_(beta),
        discriminant_((omega0 - beta) * (omega0 + beta)),
        w_(std::sqrt(std::abs(discriminant_))),
        fast_(beta + w_),
        slow_(omega0_squared_ / fast_) {}

  /// Position [m] and velocity [m/s] after `t` seconds, under a constant `push` besides [m/s^2]:
  /// x'' + 2 beta x' + omega0^2 x = push.
  State<double> move(const State<double>& start, double t, double push = 0) const;

  /// The first moment after 0 at which the velocity is zero [s], or `never`.
  double turning_time(const State<double>& start) const;

  /// The first moment at which x comes up through `level`. Needs a start at or below `level`.
  Crossing rise(const State<double>& start, double level) const;

  double acceleration(const State<double>& now) const {
    return -2 * beta_ * now.velocity - omega0_squared_ * now.position;
  }

  /// No acceleration will be larger than this [m/s^2]: v^2 + omega0^2 x^2 never grows.
  double largest_acceleration(const State<double>& now) const {
    const double v = now.velocity, x = omega0_ * now.position;
    return (2 * beta_ + omega0_) * std::sqrt(v * v + x * x);  // as hypot, but alike everywhere
  }

 private:
  double push_series(double t) const;
  Crossing upward_zero(const State<double>& start) const;
  Crossing rise_below_rest(const State<double>& start, double level) const;

  double omega0_;
  double omega0_squared_;
  double beta_;
  double discriminant_;
  double w_;
  double fast_;  // beta + w: the faster rate of an over-damped movement
  double slow_;  // beta - w, without the cancellation
};

// The formulas are inline: the exact solution is made of nothing else.

inline State<double> DampedOscillator::move(const State<double>& start, double t,
                                            double push) const {
  // x(t) = x0 (C + beta S) + v0 S,  v(t) = v0 (C - beta S) - omega0^2 x0 S, where S(t) answers a
  // kick: S(0) = 0, S'(0) = 1; and C = S' + beta S.
  double S, C_plus, C_minus;
  if (discriminant_ > 0) {
    const double envelope = std::exp(-beta_ * t);
    S = envelope * std::sin(w_ * t) / w_;
    const double C = envelope * std::cos(w_ * t);
    C_plus = C + beta_ * S;
    C_minus = C - beta_ * S;
  } else {
    const double envelope = std::exp(-slow_ * t);
    const double lead = w_ > 0 ? -std::expm1(-2 * w_ * t) / (2 * w_) : t;
    S = envelope * lead;
    C_plus = envelope * (1 + slow_ * lead);
    C_minus = w_ * t > 0.5 ? envelope * (fast_ * std::exp(-2 * w_ * t) - slow_) / (2 * w_)
                           : envelope * (1 - fast_ * lead);
  }
  // A push of 1 m/s^2 displaces the ball by K(t) = (1 - C_plus) / omega0^2, and K' = S. For a soft
  // spring that is t^2/2 and a little less, which the difference would lose: so, without it.
  double K = 0;
  if (push != 0) {
    if ((omega0_ + beta_) * t < 0.5) {
      K = push_series(t);
    } else if (discriminant_ > 0) {
      K = (1 - C_plus) / omega0_squared_;
    } else {
      K = (-std::expm1(-slow_ * t) / slow_ - S) / fast_;
    }
  }
  return {start.position * C_plus + start.velocity * S + push * K,
          start.velocity * C_minus - omega0_squared_ * start.position * S + push * S};
}

/// K(t) as a power series: K'' = 1 - 2 beta K' - omega0^2 K, from rest. For small t it needs no
/// more than some ten terms.
inline double DampedOscillator::push_series(double t) const {
  double before = 0, term = t * t / 2, sum = 0;  // the terms of order n - 1 and n
  // Without damping every other term is 0, so that it takes two to be done.
  for (int n = 2; n < 40 && (sum + term != sum || sum + before != sum); ++n) {
    sum += term;
    const double next =
        -(2 * beta_ * t * n * term + omega0_squared_ * t * t * before) / (n * (n + 1.0));
    before = term;
    term = next;
  }
  return sum;
}

inline double DampedOscillator::turning_time(const State<double>& start) const {
  const double v = start.velocity;
  const double push = omega0_squared_ * start.position;
  if (discriminant_ > 0) {
    const double angle = std::atan2(w_ * v, beta_ * v + push);  // tan(w t) = w v / (beta v + push)
    return (angle > 0 ? angle : angle + std::numbers::pi) / w_;
  }
  const double ratio = (slow_ * v + push) / (fast_ * v + push);  // = exp(-2 w t)
  const double lead = v / (fast_ * v + push);
  if (!(ratio > 0) || !(lead > 0)) return never;
  if (w_ == 0) return lead;
  return 2 * w_ * lead < 0.5 ? -std::log1p(-2 * w_ * lead) / (2 * w_) : -std::log(ratio) / (2 * w_);
}

/// The first moment at which x comes up through 0, by formula.
inline Crossing DampedOscillator::upward_zero(const State<double>& start) const {
  const double x = start.position, v = start.velocity;
  if (discriminant_ > 0) {
    // x(t) = exp(-beta t) (p cos w t + q sin w t) / w, a sine that starts at the angle atan2(p, q).
    const double p = w_ * x, q = v + beta_ * x;
    const double angle = p > 0 || q < 0 ? std::numbers::pi + std::atan2(p, -q) : std::atan2(-p, q);
    const double t = angle / w_;
    return {t, std::exp(-beta_ * t) * std::sqrt(p * p + q * q)};
  }
  const double lead = -x / (v + slow_ * x);  // as in move(): x0 + (v0 + slow x0) lead = 0
  if (x > 0 || !(v + slow_ * x > 0) || 2 * w_ * lead >= 1) return {never, 0};
  const double t = w_ > 0 ? -std::log1p(-2 * w_ * lead) / (2 * w_) : lead;
  return {t, move(start, t).velocity};
}

inline Crossing DampedOscillator::rise(const State<double>& start, double level) const {
  if (start.position >= level && start.velocity > 0) return {0, start.velocity};
  if (level < 0) return rise_below_rest(start, level);

  // The search begins where x rises and is not negative. From there to the top x'' < 0, so that
  // Newton's method comes from below and never steps over the root; and as the first top is the
  // highest, no crossing can be missed. Knowing x'' costs nothing: Halley's method uses it, and
  // each of its steps trebles the number of right digits.
  double t = 0;
  State<double> now = start;
  if (!(start.position >= 0 && start.velocity > 0)) {
    const Crossing zero = upward_zero(start);
    if (zero.t == never) return zero;
    t = zero.t;
    now = {0, zero.velocity};
  }
  for (int i = 0; i < 100; ++i) {
    const double v = now.velocity, a = acceleration(now);
    const double missing = level - now.position;
    if (!(v > 0)) return {never, 0};  // past the top, and it was too low
    // v^2 + omega0^2 x^2 never grows: it cannot rise by more than v / omega0.
    if (v < omega0_ * missing) return {never, 0};
    const double newton = missing / v;
    const double bend = newton * a / v;
    const double step = std::abs(bend) < 0.2 ? newton / (1 + bend / 2) : newton;
    if (omega0_ * std::abs(step) < 1e-5 && std::abs(bend) < 1e-5) {
      // What the next step would add is the cube of this one: below rounding. The velocity by
      // Taylor's series, for the same reason.
      const double jerk = acceleration({v, a});
      return {t + step, v + (a + jerk * step / 2) * step};
    }
    t += step;
    now = move(start, t);
  }
  return {t, now.velocity};
}

/// A level below the rest position is always reached. Between two turning points x is monotone, so
/// that the bracket is known; Newton's method is kept inside it by bisection.
inline Crossing DampedOscillator::rise_below_rest(const State<double>& start, double level) const {
  double low = 0;  // a moment from which on x rises
  if (start.velocity < 0) low = turning_time(start);
  double high = low + 1 / (discriminant_ > 0 ? omega0_ : slow_);
  while (move(start, high).position < level) high = low + 2 * (high - low);

  double t = (low + high) / 2;
  for (int i = 0; i < 100; ++i) {
    const State<double> now = move(start, t);
    const double miss = now.position - level;
    (miss < 0 ? low : high) = t;
    double next = t - miss / now.velocity;
    if (!(low < next && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) <= 2 * std::numeric_limits<double>::epsilon() * t) {
      return {next, now.velocity};
    }
    t = next;
  }
  return {t, move(start, t).velocity};
}

}  // namespace bounce
