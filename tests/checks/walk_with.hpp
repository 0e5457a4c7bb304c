#pragma once
#include "checks/subject.hpp"
#include "physics/state.hpp"

namespace bounce::check {

/// A scene for a method: the law, with a count of how often it is asked.
struct CountedLaw {
  const Walk& walk;
  mutable long long evaluations = 0;
  double acceleration(double t, const State<double>& state) const {
    ++evaluations;
    return walk.law(t, state.position, state.velocity);
  }
};

/// The walk, by a method: a learner's, or one that it is compared with.
template <class Method>
Walked walk_with(Method& method, const Walk& walk) {
  const CountedLaw scene{walk};
  State<double> state{walk.y, walk.v};
  Walked walked;
  for (long i = 0; i < walk.steps; ++i) {
    method(scene, walk.t + static_cast<double>(i) * walk.dt, state, walk.dt);
    const bool is_noted = walk.every > 0 ? (i + 1) % walk.every == 0 : i + 1 == walk.steps;
    if (is_noted) walked.states.push_back({state.position, state.velocity});
  }
  walked.evaluations = scene.evaluations;
  return walked;
}

}  // namespace bounce::check
