#pragma once
#include <string>

#include "run/simulation.hpp"

namespace bounce {

/// The largest step [s] that sees a swinging floor: a quarter of its swing. With longer ones it
/// would be another, slower floor, as a wheel in a film turns backwards. Infinity where nothing
/// swings.
double longest_seeing_step(const Simulation& simulation);

/// The step of `--dt auto` [s]: comfortable_step (stability.hpp), or less where this method's
/// bounces would not be right to 0.01.
double comfortable_step_of(const Method& method, const ContactNumbers& contact);

/// One sentence when the time step is too large for the contact, with the step that would do; else
/// empty.
std::string step_warning(const Simulation& simulation);

}  // namespace bounce
