#include "many_balls/lammps.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace bounce;

// LAMMPS adds the same forces in another order. A rounding of 1e-16 m grows in each collision:
// after 1000 steps, in which each ball collides several times, to some 1e-13 m.
TEST_CASE("many balls: 1000 balls are where LAMMPS has them after 1000 steps of collapse") {
  std::ifstream file(BOUNCE_SOURCE_DIR "/tests/many_balls/lammps_reference.csv");
  std::string comment;
  std::getline(file, comment);
  test::Crowd crowd = test::collapse(1000);
  Eigen::Matrix3Xd reference(3, 1000);
  for (auto p : reference.colwise()) {
    char comma;
    file >> p.x() >> comma >> p.y() >> comma >> p.z();
  }
  REQUIRE(file);
  many::ManyBalls balls;
  Eigen::Matrix3Xd acceleration;
  balls.move(crowd.laws(), crowd.scene.mass, crowd.scene.radius, crowd.balls, acceleration,
             many::Stepping::velocity_verlet, 1000, 1e-4);
  CHECK(test::contacts(crowd) > 1000);  // it did become a heap
  const double furthest = (crowd.balls.position - reference).cwiseAbs().maxCoeff();
  INFO("furthest from LAMMPS: ", furthest, " m");
  CHECK(furthest < 1e-12);
}
