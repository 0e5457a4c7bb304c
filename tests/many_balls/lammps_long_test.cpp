#include <doctest/doctest.h>

#include "many_balls/lammps.hpp"

using namespace bounce;

// As lammps_test.cpp, with the LAMMPS of this machine, and more than one law.
TEST_CASE("many balls: LAMMPS, run now, has them in the same places") {
  for (const bool is_damped : {true, false}) {
    const double stiffness = is_damped ? 1e5 : 2e4, damping = is_damped ? 100 : 0;
    test::Crowd crowd = test::collapse(1000);
    crowd.scene.stiffness = stiffness;
    crowd.scene.damping = damping;
    crowd.scene.floor_damping = damping / 3;
    const auto lammps = test::run_lammps(crowd, 1000, 1e-4);
    if (!lammps) {
      MESSAGE("lmp is not installed here (Debian: lammps)");
      return;
    }
    many::ManyBalls balls;
    Eigen::Matrix3Xd acceleration;
    balls.move(crowd.laws(), crowd.scene.mass, crowd.scene.radius, crowd.balls, acceleration,
               many::Stepping::velocity_verlet, 1000, 1e-4);
    const double furthest = (crowd.balls.position - lammps->balls.position).cwiseAbs().maxCoeff();
    INFO("k = ", stiffness, ", c = ", damping, ": furthest from LAMMPS: ", furthest, " m");
    CHECK(furthest < 1e-12);
    MESSAGE("furthest from LAMMPS: ", furthest, " m");
  }
}
