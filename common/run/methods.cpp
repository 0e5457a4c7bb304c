#include "run/methods.hpp"

#include <limits>

#include "physics/stability.hpp"
#include "physics/text.hpp"

namespace bounce {

std::string name_of(Method method) {
  switch (method) {
    case Method::explicit_euler:
      return "explicit-euler";
    case Method::semi_implicit_euler:
      return "semi-implicit-euler";
    case Method::velocity_verlet:
      return "velocity-verlet";
    case Method::rk4:
      return "rk4";
    case Method::rk4_events:
      return "rk4-events";
    case Method::flight_rk4:
      return "flight-rk4";
    case Method::reference:
      return "reference";
    case Method::exact:
      break;
  }
  return "exact";
}

int force_evaluations_per_step(Method method) {
  switch (method) {
    case Method::rk4:
      return 4;
    case Method::rk4_events:
    case Method::flight_rk4:
    case Method::reference:
    case Method::exact:
      return 0;
    default:
      return 1;
  }
}

double largest_stable_step(Method method, double omega0, double zeta) {
  switch (method) {
    case Method::explicit_euler:
      return explicit_euler_limit(zeta) / omega0;
    case Method::semi_implicit_euler:
    case Method::velocity_verlet:
      return semi_implicit_euler_limit(zeta) / omega0;
    case Method::rk4:
    case Method::rk4_events:
    case Method::flight_rk4:
      return rk4_limit(zeta) / omega0;
    case Method::reference:
    case Method::exact:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

namespace {

std::vector<std::string> words(const std::vector<Method>& methods) {
  std::vector<std::string> names;
  for (const Method method : methods) names.push_back(name_of(method));
  return names;
}

}  // namespace

Method find_method(const std::string& name, const std::vector<Method>& offered) {
  for (const Method method : offered) {
    if (name_of(method) == name) return method;
  }
  throw BadInput("--method '" + name + "' is not known here" + did_you_mean(name, words(offered)) +
                 ": it must be one of " + names_of(offered));
}

std::string names_of(const std::vector<Method>& methods) { return join(words(methods)); }

}  // namespace bounce
