// A better loop: a learner's own method (mine_method.hpp) under check.
#ifndef BOUNCE_STAGE_HEADER
#define BOUNCE_STAGE_HEADER "02_spring_floor/own_method/my_method.hpp"
#endif
#include BOUNCE_STAGE_HEADER
#include <Eigen/Core>

#include "checks/walk_with.hpp"

using namespace bounce;

namespace {

/// The law in each direction. As stage 5 does, it answers with a reference to what it keeps, and so
/// the next answer takes the place of the last one.
struct LawInSpace {
  const check::Walk& walk;
  mutable Eigen::Vector3d kept;
  const Eigen::Vector3d& acceleration(double t, const State<Eigen::Vector3d>& state) const {
    for (int i = 0; i < 3; ++i) kept[i] = walk.law(t, state.position[i], state.velocity[i]);
    return kept;
  }
};

class Subject final : public check::Subject {
 public:
  check::Walked walk(const check::Walk& walk) const override {
    MyMethod<double> method;
    return check::walk_with(method, walk);
  }
  check::Motion walk_in_space(const check::Walk& walk, const check::Motion& start) const override {
    const auto vector = [](const check::Triple& x) { return Eigen::Vector3d(x[0], x[1], x[2]); };
    const auto triple = [](const Eigen::Vector3d& x) { return check::Triple{x[0], x[1], x[2]}; };
    const LawInSpace scene{walk, Eigen::Vector3d::Zero()};
    State<Eigen::Vector3d> state{vector(start.position), vector(start.velocity)};
    MyMethod<Eigen::Vector3d> method;
    for (long i = 0; i < walk.steps; ++i) {
      method(scene, walk.t + static_cast<double>(i) * walk.dt, state, walk.dt);
    }
    return {triple(state.position), triple(state.velocity)};
  }
};

}  // namespace

#include "adapt.hpp"
BOUNCE_SUBJECT(Subject)
