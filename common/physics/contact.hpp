#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace bounce {

/// What happens when spring and damper together would *pull* the ball towards the floor, as they
/// do just before lift-off: the slides let them, a contact that only pushes does not.
enum class ContactLaw { may_pull, push_only };

/// Spring and damper side by side (Kelvin-Voigt model) between a ball and what it overlaps.
struct SpringDamper {
  double stiffness = 1e4;  // k [N/m], > 0
  double damping = 0;      // c [N s/m], >= 0
  ContactLaw law = ContactLaw::may_pull;

  /// Force [N] that pushes the two apart, from the overlap [m] and the speed at which they
  /// separate [m/s, positive when the overlap shrinks]. Without overlap there is no force.
  double force(double overlap, double separation_speed) const {
    if (!(overlap > 0)) return 0;
    const double force = stiffness * overlap - damping * separation_speed;
    return law == ContactLaw::push_only ? std::max(0.0, force) : force;
  }
};

/// omega0 = sqrt(k/m) [rad/s]: the angular frequency of the undamped contact. `mass` is the ball's
/// for a fixed floor, and m1 m2 / (m1 + m2) for a pair of balls.
inline double natural_frequency(double stiffness, double mass) {
  return std::sqrt(stiffness / mass);
}

/// zeta = c / (2 sqrt(k m)): below 1 the contact oscillates (under-damped), above 1 it creeps.
inline double damping_ratio(double stiffness, double damping, double mass) {
  return damping / (2 * std::sqrt(stiffness * mass));
}

// The two formulas below hold for a ball that comes in with any speed and *without gravity*; with
// gravity the restitution also depends on the speed (docs/deeper/03_damping.md). They follow from
// the damped oscillator x'' + 2 beta x' + omega0^2 x = 0 that starts at x = 0.

/// How long a contact lasts [s]. `may_pull`: until the overlap is gone, pi / omega_d, and for ever
/// (infinity) from zeta = 1 on. `push_only`: until the force is gone, which is sooner and finite.
/// Source: Schwager and Poeschel, Granular Matter 9, 465 (2007); their formula for zeta < 1,
/// (pi - atan2(2 beta omega_d, omega0^2 - 2 beta^2)) / omega_d, is written here as twice half the
/// angle, and the one for zeta > 1 as an inverse hyperbolic sine: both keep all digits near zeta
/// = 1.
inline double contact_time(const SpringDamper& contact, double mass) {
  const double omega0 = natural_frequency(contact.stiffness, mass);
  const double beta = contact.damping / (2 * mass);
  const double discriminant = (omega0 - beta) * (omega0 + beta);  // omega_d^2 when positive
  if (contact.law == ContactLaw::may_pull) {
    if (discriminant <= 0) return std::numeric_limits<double>::infinity();
    return std::acos(-1.0) / std::sqrt(discriminant);
  }
  if (discriminant == 0) return 2 / omega0;
  const double omega = std::sqrt(std::abs(discriminant));
  return 2 * (discriminant > 0 ? std::atan2(omega, beta) : std::asinh(omega / omega0)) / omega;
}

/// Coefficient of restitution: speed after the contact / speed before it, e = exp(-beta t_c).
inline double restitution(const SpringDamper& contact, double mass) {
  if (contact.damping == 0) return 1;
  return std::exp(-contact.damping / (2 * mass) * contact_time(contact, mass));
}

}  // namespace bounce
