#include <doctest/doctest.h>

#include "many_balls/crowds.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "sanitizers.hpp"

using namespace bounce;

// The grid gives its pairs in the order of the double loop, and the fast path adds the forces on
// each ball in that order: so the bound is not 1e-12 m, but nothing.
TEST_CASE("many balls: a thousand collapse as with all pairs, to the last bit") {
  test::Crowd all_pairs = test::collapse(1000), grid = all_pairs, fast = all_pairs;
  all_pairs.scene.grid_from = 1000000;
  VelocityVerlet<Eigen::Matrix3Xd> with_all, with_grid;
  const int steps = test::is_sanitized ? 200 : 1000;  // they take the sanitizers 0.1 s each
  for (int i = 0; i < steps; ++i) {
    with_all(all_pairs.scene, 0, all_pairs.balls, 1e-4);
    with_grid(grid.scene, 0, grid.balls, 1e-4);
  }
  many::ManyBalls balls;
  Eigen::Matrix3Xd acceleration;
  balls.move(fast.laws(), fast.scene.mass, fast.scene.radius, fast.balls, acceleration,
             many::Stepping::velocity_verlet, steps, 1e-4, 2);
  CHECK(test::contacts(fast) > 500);
  CHECK(grid.balls.position == all_pairs.balls.position);
  CHECK(fast.balls.position == all_pairs.balls.position);
  CHECK(fast.balls.velocity == all_pairs.balls.velocity);
  CHECK(acceleration == *with_all.acceleration);
}
