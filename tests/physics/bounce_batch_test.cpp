#include "speed_vs_error/bounce_batch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "random_numbers.hpp"
#include "reference_values.hpp"

using namespace bounce;

TEST_CASE("a ball in a lane agrees with 50 digits") {
  for (const test::ReferenceValue& r : test::reference_values) {
    const SweepBall ball{
        r.mass, r.gravity, r.radius, {r.stiffness, r.damping, r.law}, {r.position, r.velocity}};
    // Nine of them: more than there are lanes.
    const std::vector<State<double>> states = exact_states(std::vector<SweepBall>(9, ball), r.t);
    for (const State<double>& state : states) {
      CAPTURE(r.stiffness);
      CAPTURE(r.damping);
      CAPTURE(r.t);
      // As for a ball alone (exact_test.cpp), and as much again for the lanes' own sine and
      // arc tangent.
      const double size = std::min(1.0, r.position), speed = std::sqrt(2 * 9.81 * size);
      CHECK(std::abs(state.position - r.y) < 8e-15 * size);
      CHECK(std::abs(state.velocity - r.v) < 4e-14 * speed);
    }
  }
}

TEST_CASE("a batch of balls in lanes agrees with each ball alone") {
  std::mt19937 random(5);
  const auto between = [&](double a, double b) { return test::uniform(random, a, b); };
  std::vector<SweepBall> balls;
  for (int i = 0; i < 2003; ++i) {
    const double m = between(0.1, 3), k = std::pow(10, between(3, 5));
    const double zeta = i % 3 == 0 ? 0 : between(0, i % 3 == 1 ? 0.1 : 0.98);
    balls.push_back({m,
                     between(1, 20),
                     0.1,
                     {k, 2 * zeta * std::sqrt(k * m)},
                     {between(0.1, 2), between(-3, 3)}});
  }
  // A few that are not usual, anywhere, go one by one.
  balls.push_back({1, 9.81, 0.1, {1e4, 5, ContactLaw::push_only}, {1, 0}});
  balls.push_back({1, 9.81, 0.1, {1e4, 500}, {1, 0}});
  balls.push_back({1, 9.81, 0.1, {1e4, 5}, {0.05, 0}});
  test::shuffle(balls.end() - 40, balls.end(), random);
  for (const double t : {0.05, 0.7, 2.0, 5.0}) {
    const std::vector<State<double>> states = exact_states(balls, t);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const SweepBall& b = balls[i];
      EventDriven<BouncePhases> alone(BouncePhases(b.mass, b.gravity, b.radius, b.contact), 0,
                                      b.start);
      const State<double> state = alone.at(t);
      CAPTURE(i);
      CAPTURE(t);
      // Two ways of rounding: each of up to 20 bounces shifts the next by some 1e-16 s x 6 m/s, and
      // multiplies the shifts before it by no more than 1. In contact the velocity changes by
      // up to omega0 x speed = 6e3 m/s^2.
      CHECK(std::abs(states[i].position - state.position) < 1e-13);
      CHECK(std::abs(states[i].velocity - state.velocity) < 1e-11);
    }
  }
}
