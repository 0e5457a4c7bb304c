// Stands in for a peer that was not installed when CMake looked.

#include "speed_vs_error/subjects.hpp"

namespace bounce::report {

#ifndef HAS_ODEINT
void add_odeint(Case& /*on*/, double /*damping*/) {}
#endif
#ifndef HAS_CVODE
void add_cvode(Case& /*on*/, double /*damping*/) {}
#endif

}  // namespace bounce::report
