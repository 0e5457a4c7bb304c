#pragma once
#include "run/simulation.hpp"

namespace bounce {

/// A bounce's restitution (speed after it / speed before it): as it is, and as a method computes it
/// at the worst moment at which the ball can touch within a step.
struct WorstBounce {
  double is;        // by formula (contact.hpp)
  double computed;  // the furthest from it
  double error() const;
};

/// Measured, not estimated: the method itself takes a ball through 192 bounces without gravity, on
/// a contact with the same damping ratio and law, with the same omega0 dt. That is all a
/// restitution depends on. For methods that go by steps; RK4 stands in for those that are RK4 and
/// locate touches besides, the lecture's loop for a learner's.
WorstBounce worst_bounce(const Method& method, const ContactNumbers& contact, double dt);

/// The step of `--dt auto` [s]: comfortable_step (stability.hpp), or less where this method's
/// bounces would not be right to 0.01.
double comfortable_step_of(const Method& method, const ContactNumbers& contact);

}  // namespace bounce
