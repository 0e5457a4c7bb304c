#include "run/restitution_error.hpp"

#include <cmath>
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

}  // namespace

double WorstBounce::error() const { return std::abs(computed - is); }

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

double comfortable_step_of(const Method& method, const ContactNumbers& contact) {
  constexpr double accuracy = 0.01;
  double dt = comfortable_step(contact.omega0, contact.zeta);
  for (double error = 1; dt * contact.omega0 > 1e-4; dt *= 0.95 * accuracy / error) {
    error = worst_bounce(method, contact, dt).error();
    if (error <= accuracy) break;
  }
  return dt;
}

}  // namespace bounce
