#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "physics/components.hpp"
#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/neighbour_grid.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// One ball at one moment: what two balls need to know of each other.
struct Ball {
  Eigen::Vector3d position;  // m
  Eigen::Vector3d velocity;  // m/s
  double radius;             // m
};

/// How two balls touch, or do not.
struct Meeting {
  double overlap;                // m; not positive: they do not touch, and the rest is empty
  Eigen::Vector3d e12{0, 0, 0};  // unit vector from ball 2 to ball 1
  double separation_speed = 0;   // m/s, along e12
};

// [meeting]
inline Meeting meet(const Ball& ball1, const Ball& ball2) {
  const Eigen::Vector3d between = ball1.position - ball2.position;
  const double d = between.norm();
  Meeting meeting{ball1.radius + ball2.radius - d};
  if (!(meeting.overlap > 0)) return meeting;
  // Where the centres coincide there is no direction: ball 1, the one with the lower number, goes
  // up. (Below 1e-100 m the squares in d underflow, and the direction would be noise.)
  meeting.e12 = Eigen::Vector3d::UnitY();
  if (d > 1e-100) meeting.e12 = between / d;
  meeting.separation_speed = dot(ball1.velocity - ball2.velocity, meeting.e12);
  return meeting;
}
// [meeting]

// [pair]
/// The force on ball 1 [N]; the force on ball 2 is the opposite one. The slides point e12 from ball
/// 2 to ball 1, as here, and then call k (2r - d) e12 the force on ball 2: it is the one on ball 1.
inline Eigen::Vector3d pair_force(const Ball& ball1, const Ball& ball2,
                                  const SpringDamper& contact) {
  const Meeting meeting = meet(ball1, ball2);
  return contact.force(meeting.overlap, meeting.separation_speed) * meeting.e12;
}
// [pair]

/// Stage 5. Balls that meet each other, a floor and the walls of a tray. y is up.
/// The state is a 3-by-N matrix of positions and one of velocities: a column for each ball.
struct BallCollision {
  double gravity = 9.81;   // m/s^2
  double stiffness = 1e4;  // N/m, between two balls
  double damping = 0;      // N s/m, between two balls
  ContactLaw contact = ContactLaw::may_pull;
  bool floor = true;             // at height 0
  double floor_stiffness = 1e4;  // N/m, of floor and walls
  double floor_damping = 0;      // N s/m
  std::array<double, 2> tray{};  // m: walls at x = 0 and LX, z = 0 and LZ; 0: none that way
  Eigen::VectorXd mass;          // kg, one for each ball
  Eigen::VectorXd radius;        // m
  Eigen::Index grid_from = 48;   // with fewer balls the double loop is faster (see docs/deeper)

  using Matrix = Eigen::Matrix3Xd;

  /// What each ball's acceleration is [m/s^2], a column for each. The matrix is kept, so that a
  /// step allocates nothing; it holds until the next call.
  const Matrix& acceleration(double /*t*/, const State<Matrix>& state) const;

  Energy energy(const State<Matrix>& state) const;              // [J], of all balls together
  double damper_power(const State<Matrix>& state) const;        // [W] what the dampers take now
  Eigen::Vector3d momentum(const State<Matrix>& state) const {  // [kg m/s]
    return state.velocity * mass;
  }

  std::vector<Parameter> parameters() {
    const char* meaning = "the same for floor and walls";
    return {describe::gravity(gravity),
            describe::stiffness(stiffness),
            describe::damping(damping),
            describe::contact(contact),
            describe::floor(floor),
            {"floor_stiffness", "N/m", meaning, &floor_stiffness, {1e-30, 1e30}, {500, 1e5}},
            {"floor_damping", "N s/m", meaning, &floor_damping, {0, 1e30}, {0, 300}},
            {"tray",
             "m",
             "walls at x = 0 and LX, z = 0 and LZ; 0 for none",
             Components(tray),
             {0, 1e15},
             {0, 5}}};
  }

  Ball ball(const State<Matrix>& state, Eigen::Index i) const {
    return {state.position.col(i), state.velocity.col(i), radius[i]};
  }
  SpringDamper pair_contact() const { return {stiffness, damping, contact}; }
  SpringDamper floor_contact() const { return {floor_stiffness, floor_damping, contact}; }

  /// Calls visit(i, j), i < j, for the pairs of balls that may touch.
  template <class Visit>
  void for_each_pair(const Matrix& position, const Visit& visit) const;
  /// Calls visit(axis, sign, overlap) for floor and walls; they push ball i along sign * axis.
  template <class Visit>
  void for_each_surface(const Matrix& position, Eigen::Index i, const Visit& visit) const;

 private:
  mutable Matrix force_;  // and, divided by the masses, acceleration
  mutable NeighbourGrid grid_;
};

// [acceleration]
inline const Eigen::Matrix3Xd& BallCollision::acceleration(double /*t*/,
                                                           const State<Matrix>& state) const {
  const SpringDamper from_floor = floor_contact(), from_ball = pair_contact();
  force_.setZero(3, mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    force_(1, i) -= mass[i] * gravity;  // gravity, downwards
    for_each_surface(state.position, i, [&](Eigen::Index axis, double sign, double overlap) {
      force_(axis, i) += sign * from_floor.force(overlap, sign * state.velocity(axis, i));
    });
  }
  for_each_pair(state.position, [&](Eigen::Index i, Eigen::Index j) {
    const Eigen::Vector3d force = pair_force(ball(state, i), ball(state, j), from_ball);
    force_.col(i) += force;  // equal
    force_.col(j) -= force;  // and opposite
  });
  for (Eigen::Index i = 0; i < mass.size(); ++i) force_.col(i) /= mass[i];  // a = F / m
  return force_;
}
// [acceleration]

// [pairs]
template <class Visit>
void BallCollision::for_each_pair(const Matrix& position, const Visit& visit) const {
  if (mass.size() >= grid_from) {
    for (const auto& [i, j] : grid_.pairs(position, radius)) visit(i, j);
    return;
  }
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    for (Eigen::Index j = i + 1; j < mass.size(); ++j) visit(i, j);
  }
}
// [pairs]

template <class Visit>
void BallCollision::for_each_surface(const Matrix& position, Eigen::Index i,
                                     const Visit& visit) const {
  const double r = radius[i];
  if (floor) visit(1, 1, r - position(1, i));
  if (tray[0] > 0) {
    visit(0, 1, r - position(0, i));
    visit(0, -1, r - (tray[0] - position(0, i)));
  }
  if (tray[1] > 0) {
    visit(2, 1, r - position(2, i));
    visit(2, -1, r - (tray[1] - position(2, i)));
  }
}

inline Energy BallCollision::energy(const State<Matrix>& state) const {
  Energy sum;
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    sum.kinetic += kinetic_energy(mass[i], state.velocity.col(i));
    sum.gravitational += gravitational_energy(mass[i], gravity, state.position(1, i));
    for_each_surface(state.position, i, [&](Eigen::Index, double, double overlap) {
      sum.spring += spring_energy(floor_stiffness, overlap);
    });
  }
  for_each_pair(state.position, [&](Eigen::Index i, Eigen::Index j) {
    sum.spring += spring_energy(stiffness, meet(ball(state, i), ball(state, j)).overlap);
  });
  return sum;
}

inline double BallCollision::damper_power(const State<Matrix>& state) const {
  const SpringDamper from_floor = floor_contact(), from_ball = pair_contact();
  double power = 0;
  // The part of the force that is not the spring's, times the speed against which it acts.
  const auto add = [&power](const SpringDamper& law, double overlap, double separation_speed) {
    if (!(overlap > 0)) return;
    const double damper = law.force(overlap, separation_speed) - law.stiffness * overlap;
    power -= damper * separation_speed;
  };
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    for_each_surface(state.position, i, [&](Eigen::Index axis, double sign, double overlap) {
      add(from_floor, overlap, sign * state.velocity(axis, i));
    });
  }
  for_each_pair(state.position, [&](Eigen::Index i, Eigen::Index j) {
    const Meeting m = meet(ball(state, i), ball(state, j));
    add(from_ball, m.overlap, m.separation_speed);
  });
  return power;
}

}  // namespace bounce
