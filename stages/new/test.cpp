// What stage 3 claims. ./course test 3 runs this alone.
#include <doctest/doctest.h>

#include "03_damping/damping.hpp"
#include "plain/trace.hpp"

using namespace bounce;

TEST_CASE("stage 3: a ball that rests on the floor has no force on it") {
  const Damping scene;
  const double sag = scene.mass * scene.gravity / scene.stiffness;
  // One rounding of the overlap, 1e-17 m, is 1e-13 N.
  CHECK(scene.force(0, {scene.radius - sag, 0}) == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("stage 3: the program on one page prints the same rows as the demo, to the bit") {
  const test::Trace plain = test::trace_of("03_damping_plain");
  const test::Trace demo = test::trace_of("03_damping" + test::same_method);
  CHECK(plain.header == demo.header);
  CHECK(plain.rows.size() == 10001);
  CHECK(plain.rows == demo.rows);
}
