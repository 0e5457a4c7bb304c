#include "run/step_warning.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "run/restitution_error.hpp"

namespace bounce {

double longest_seeing_step(const Simulation& simulation) {
  const double rate = simulation.traits().swing_rate;
  const bool steps = !simulation.method().goes_by_events;
  return rate > 0 && steps ? std::numbers::pi / 2 / rate : std::numeric_limits<double>::infinity();
}

std::string step_warning(const Simulation& simulation) {
  if (const double seeing = longest_seeing_step(simulation); simulation.dt() > seeing) {
    return "dt = " + to_rounded_text(simulation.dt()) +
           " s is too large to see the floor swing: take dt = " + to_rounded_text(seeing / 5, 2) +
           " s";
  }
  const std::optional<ContactNumbers> contact = simulation.contact();
  const Method& method = simulation.method();
  const bool is_known = method.stability_limit != nullptr;  // a learner's own method is not
  if (!contact || method.goes_by_events || simulation.traits().cuts_steps || !is_known) return "";
  const double dt = simulation.dt();
  const double limit = method.largest_stable_step(contact->omega0, contact->zeta);
  const auto good_for = [&](const Method& of) {
    const double step = comfortable_step_of(of, *contact);
    return to_rounded_text(limit > 0 ? std::min(step, limit / 2) : step, 2) + " s";
  };
  if (limit == 0) {
    return name_of(method) +
           " gains energy on an undamped spring at every time step: take semi-implicit-euler with "
           "dt = " +
           good_for(methods::semi_implicit_euler);
  }
  if (dt > limit) {
    return "dt = " + to_rounded_text(dt) + " s is too large: " + name_of(method) +
           " is stable up to " + to_rounded_text(limit) +
           " s on this contact, and good to look at with " + good_for(method);
  }
  constexpr double small = 0.05;  // omega0 dt: here no method is wrong by more than 0.08
  constexpr double wrong = 0.1;   // of the restitution: from here on it can be seen
  if (dt * contact->omega0 < small) return "";
  const WorstBounce bounce = worst_bounce(method, *contact, dt);
  if (bounce.error() <= 0.95 * wrong) return "";
  return "dt = " + to_rounded_text(dt) + " s is stable on this contact, but a bounce can have " +
         "restitution " + to_rounded_text(bounce.computed, 2) + " in place of " +
         to_rounded_text(bounce.is, 2) + ": take dt = " + good_for(method) + " (--dt auto)";
}

}  // namespace bounce
