#include "run/step_warning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "physics/stability.hpp"
#include "run/any_method.hpp"

namespace bounce {
namespace {

/// A ball of mass 1 above a floor at height 0 with omega0 = 1.
struct SmallBounce {
  SpringDamper contact;
  double acceleration(double /*t*/, const State<double>& ball) const {
    return contact.force(-ball.position, ball.velocity);
  }
};

/// The speed at which a ball leaves that came in at speed 1, and touched `early` (from 0 to 1) of a
/// step before the step's end. Of one that does not leave: its speed then.
template <class Method>
double bounce_once(Method method, const SmallBounce& scene, double dt, double early) {
  State<double> ball{dt * (1 - early), -1};
  for (double t = 0; t < 100; t += dt) {
    method(scene, t, ball, dt);
    if (ball.position > 0 && ball.velocity > 0) break;
    const bool rests = ball.position <= 0 && std::hypot(ball.position, ball.velocity) < 0.01;
    if (rests) break;
  }
  return std::abs(ball.velocity);
}

/// A bounce's restitution (speed after it / speed before it): as it is, and as a method computes it
/// at the worst moment at which the ball can touch within a step.
struct WorstBounce {
  double is;        // by formula (contact.hpp)
  double computed;  // the furthest from it
  double error() const { return std::abs(computed - is); }
};

/// Measured, not estimated: the method itself takes a ball through 192 bounces without gravity, on
/// a contact with the same damping ratio and law, with the same omega0 dt. That is all a
/// restitution depends on. For methods that go by steps; RK4 stands in for those that are RK4 and
/// locate touches besides, the lecture's loop for a learner's.
WorstBounce measure(const Method& method, const ContactNumbers& contact, double dt) {
  constexpr int moments = 192;
  const SmallBounce scene{{1, 2 * contact.zeta, contact.law}};
  AnyMethod<SteppingMethods<double>> one_ball;
  one_ball.begin(method.order == 4 ? methods::rk4 : methods::semi_implicit_euler);
  one_ball.begin(method);
  const double is = restitution(scene.contact, 1);
  WorstBounce worst{is, is};
  for (int i = 0; i < moments; ++i) {
    const double early = (i + 0.5) / moments;
    const double computed = one_ball.visit(
        [&](const auto& fresh) { return bounce_once(fresh, scene, contact.omega0 * dt, early); });
    const WorstBounce now{is, computed};
    if (now.error() > worst.error()) worst = now;
  }
  return worst;
}

WorstBounce worst_bounce(const Method& method, const ContactNumbers& contact, double dt) {
  // A window asks at every picture, and mostly the same.
  struct Asked {
    Method method;
    ContactNumbers contact;
    double dt;
    bool operator==(const Asked&) const = default;
  };
  static thread_local std::optional<Asked> last;
  static thread_local WorstBounce answer{};
  const Asked now{method, contact, dt};
  if (last != now) answer = measure(method, contact, dt);
  last = now;
  return answer;
}

}  // namespace

double longest_seeing_step(const Simulation& simulation) {
  const double rate = simulation.traits().swing_rate;
  const bool steps = !simulation.method().goes_by_events;
  return rate > 0 && steps ? std::numbers::pi / 2 / rate : std::numeric_limits<double>::infinity();
}

double comfortable_step_of(const Method& method, const ContactNumbers& contact) {
  constexpr double accuracy = 0.01;
  double dt = comfortable_step(contact.omega0, contact.zeta);
  for (double error = 1; dt * contact.omega0 > 1e-4; dt *= 0.95 * accuracy / error) {
    error = worst_bounce(method, contact, dt).error();
    if (error <= accuracy) break;
  }
  return dt;
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
