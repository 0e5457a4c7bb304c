#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "physics/components.hpp"
#include "physics/state.hpp"

namespace bounce {

/// What Runge-Kutta methods that estimate their own error have in common. From the slopes of one
/// step they make the result and, weighing them otherwise, a less accurate one: the difference
/// tells how good a step was. Slopes are counted from 1, as in the books.
template <class Vector, std::size_t slopes>
class EmbeddedPair {
 public:
  /// Where the next steps start. `law.acceleration(t, state)` is what it asks.
  template <class Law>
  void start_at(const Law& law, double t, const State<Vector>& state) {
    start_at(state, law.acceleration(t, state));
    ++evaluations_;
  }
  void start_at(const State<Vector>& state, const Vector& acceleration) {
    start_ = state;
    velocity_[1] = state.velocity;
    acceleration_[1] = acceleration;
  }

  const State<Vector>& start() const { return start_; }
  const Vector& acceleration_at_start() const { return acceleration_[1]; }
  long long evaluations() const { return evaluations_; }

 protected:
  using Slopes = std::array<Vector, slopes + 1>;

  /// Slope i, at the share `c` of the step; `sum` weighs the slopes before it. (Sums of sums alone,
  /// with a minus in front of a number: so all of one length have one type, and compile quickly.)
  template <class Law, class Sum>
  void slope(const Law& law, double t, double h, std::size_t i, double c, const Sum& sum) {
    state_.position = start_.position + h * sum(velocity_);
    state_.velocity = start_.velocity + h * sum(acceleration_);
    evaluate(law, t + c * h, i);
  }
  template <class Law>
  void evaluate(const Law& law, double t, std::size_t i) {
    acceleration_[i] = law.acceleration(t, state_);
    std::swap(velocity_[i], state_.velocity);  // cheaper than a copy
    ++evaluations_;
  }

  /// What differs, in positions and in velocities [per second of the step]; a method may have two
  /// estimates of that, of which the second falls more slowly.
  struct Difference {
    const Vector& one;
    const Vector* other = nullptr;
  };
  /// The error, in units of what `tolerance` allows: 1 is just right. It is measured, ball by ball,
  /// against how fast the ball is and how far it moves.
  double in_units_allowed(double h, double tolerance, const Difference& of_velocity,
                          const Difference& of_acceleration) const;

  State<Vector> start_{};
  State<Vector> state_{};
  Slopes velocity_{}, acceleration_{};

 private:
  /// Both estimates together fall as fast as one of order 7: five^2 / sqrt(five^2 + 0.01 three^2).
  static double together(double five, double three) {
    if (five == 0) return 0;
    const double ratio = 0.1 * three / five;
    return ratio < 1e3 ? five / std::sqrt(1 + ratio * ratio) : five / ratio;
  }

  long long evaluations_ = 0;
};

template <class Vector, std::size_t slopes>
double EmbeddedPair<Vector, slopes>::in_units_allowed(double h, double tolerance,
                                                      const Difference& of_velocity,
                                                      const Difference& of_acceleration) const {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto size = [](auto numbers) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return largest;
  };
  const std::size_t count = components(start_.position).size();
  constexpr std::size_t one = std::is_same_v<Vector, double> ? 1 : 3;  // numbers a ball
  // No step can be better than the rounding of the positions, and of what follows from it.
  const double blur = 8 * epsilon * size(components(start_.position));
  tolerance = std::max(tolerance, 8 * epsilon);
  double worst = 0;
  for (std::size_t ball = 0; ball < count; ball += one) {
    const auto of = [&](const Vector& vector) { return components(vector).subspan(ball, one); };
    const double speed =
        std::max({size(of(start_.velocity)), size(of(state_.velocity)),
                  h * size(of(acceleration_[1])), h * size(of(acceleration_[slopes]))});
    const auto judge = [&](const Difference& difference, double allowed) {
      for (std::size_t i = 0; i < one; ++i) {
        double error = std::abs(of(difference.one)[i]);
        if (h * error <= worst * allowed) continue;  // both together are no more
        if (difference.other) error = together(error, std::abs(of(*difference.other)[i]));
        if (h * error > 0 && !(h * error / allowed <= worst)) worst = h * error / allowed;
      }
    };
    judge(of_velocity, tolerance * speed * h + blur);
    judge(of_acceleration, tolerance * speed + blur / h);
  }
  return worst;
}

}  // namespace bounce
