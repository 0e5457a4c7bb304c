#include "05_ball_collision/run/balls_world.hpp"

#include <algorithm>

namespace bounce {

template class RunOf<BallsWorld>;

Traits BallsWorld::traits(const Simulation& simulation) const {
  Traits all{"ball,x,y,z,vx,vy,vz", hardest_contact(), count()};
  all.truth = "reference, 1e-13";
  if (simulation.method() == methods::reference && count() > most_balls_of_reference) {
    all.refusal = "--method reference is not allowed with " + std::to_string(count()) +
                  " balls: " + why_not_so_many;
  }
  if (own_balls) all.command += " " + origin;
  if (threads != 1) all.command += " --threads " + std::to_string(threads);
  if (seed != 1) all.command += " --seed " + std::to_string(seed);
  return all;
}

/// Between the two lightest balls, or of the lightest one with the floor. (A ball that touches
/// several at a time asks for less still.)
std::optional<ContactNumbers> BallsWorld::hardest_contact() const {
  double lightest = 1e300, second = 1e300;
  for (const double mass : scene.mass) {
    second = std::min(second, std::max(mass, lightest));
    lightest = std::min(lightest, mass);
  }
  std::optional<ContactNumbers> hardest;
  const auto consider = [&](double k, double c, double mass) {
    const ContactNumbers contact{natural_frequency(k, mass), damping_ratio(k, c, mass),
                                 scene.contact};
    const auto limit = [](const ContactNumbers& of) {
      return semi_implicit_euler_limit(of.zeta) / of.omega0;
    };
    if (!hardest || limit(contact) < limit(*hardest)) hardest = contact;
  };
  if (scene.floor || scene.tray[0] > 0 || scene.tray[1] > 0) {
    consider(scene.floor_stiffness, scene.floor_damping, lightest);
  }
  if (scene.mass.size() > 1) {
    consider(scene.stiffness, scene.damping, 1 / (1 / lightest + 1 / second));
  }
  return hardest;
}

/// The reference, as tight as doubles allow, for a few balls. With many the comparison would take
/// too long, and soon be none: each collision multiplies an error, so that two runs that differ by
/// rounding part after some twenty of them.
Truth<BallsWorld::TruthWalk, BallsWorld::Vector> BallsWorld::truth(double t,
                                                                   const Balls& balls) const {
  constexpr double tolerance = 1e-13;
  constexpr std::size_t most_balls = 9;
  if (count() > most_balls) return {};
  return {TruthWalk(contacts(t, balls), t, balls, tolerance), 20000};
}

std::vector<double> BallsWorld::row(double /*t*/, const Balls& balls) const {
  std::vector<double> rows;
  rows.reserve(7 * count());
  for (Eigen::Index i = 0; i < scene.mass.size(); ++i) {
    rows.push_back(static_cast<double>(i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(balls.position(axis, i));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(balls.velocity(axis, i));
  }
  return rows;
}

void continue_from(BallsRun& run, const many::LammpsFrame& frame, const std::string& origin) {
  const Eigen::Index count = frame.balls.position.cols();
  const bool complete = frame.mass.size() == count && frame.radius.size() == count;
  if (!complete && count != run.scene().mass.size()) {
    throw BadInput(origin + " is not allowed: it has " + std::to_string(count) +
                   " balls without mass and radius, and the scene has " +
                   std::to_string(run.scene().mass.size()) +
                   ": set count, or dump the columns mass and radius as well");
  }
  Arrangement balls(count);
  balls.mass = frame.mass.size() == count ? frame.mass : run.scene().mass;
  balls.radius = frame.radius.size() == count ? frame.radius : run.scene().radius;
  balls.balls = frame.balls;
  run.world().take_over(balls, origin);

  Simulation::Memory memory = run.memory();
  memory.time = static_cast<double>(frame.step) * run.dt();
  memory.grid_start = memory.into_step = 0;
  memory.grid_steps = memory.steps = frame.step;
  NumberWriter writer;
  BallsWorld::remembered(run.world(), writer, balls.balls);
  // The acceleration at the end of the last step is part of velocity Verlet's state: with damping
  // it is not what the new velocity would give.
  if (run.method() == methods::velocity_verlet && frame.force.cols() == count) {
    Eigen::Matrix3Xd acceleration = frame.force;
    for (Eigen::Index i = 0; i < count; ++i) acceleration.col(i) /= balls.mass[i];
    writer("acceleration", acceleration);
  }
  memory.numbers = writer.take();
  run.recall(memory);
}

}  // namespace bounce
