#pragma once
#include <string>
#include <vector>

namespace bounce {

/// The ways to move time that a stage can offer. `exact` is no stepping method: it walks from event
/// to event by formula. `rk4_events` and `flight_rk4` cut their steps at the events, and the latter
/// does not step flights at all. `reference` does the same with steps that it chooses itself, as
/// `--tolerance` wants them.
enum class Method {
  explicit_euler,
  semi_implicit_euler,
  velocity_verlet,
  rk4,
  rk4_events,
  flight_rk4,
  reference,
  exact
};

/// The name on the command line: "semi-implicit-euler".
std::string name_of(Method method);

/// Whether the method goes from event to event, without a time step that the user gives.
inline bool goes_by_events(Method method) {
  return method == Method::reference || method == Method::exact;
}

/// How often a step asks for the acceleration; 0 for `exact`, which never does, and for the methods
/// that locate events, where it differs and is counted.
int force_evaluations_per_step(Method method);

/// The largest stable step [s] on a contact with these numbers; infinity for methods without dt.
double largest_stable_step(Method method, double omega0, double zeta);

/// The method of that name among those that the stage offers. Throws BadInput.
Method find_method(const std::string& name, const std::vector<Method>& offered);

/// "a, b, c"
std::string names_of(const std::vector<Method>& methods);

}  // namespace bounce
