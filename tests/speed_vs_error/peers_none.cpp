// Stands in for a peer that was not installed when CMake looked.

#include "speed_vs_error/engines.hpp"

namespace bounce::report {

#ifndef HAS_ODEINT
void add_odeint(Case& /*on*/, double /*damping*/) {}
#endif
#ifndef HAS_CVODE
void add_cvode(Case& /*on*/, double /*damping*/) {}
#endif
#ifndef HAS_BULLET
void add_bullet(std::vector<Engine>& /*to*/) {}
#endif
#ifndef HAS_ODE
void add_ode(std::vector<Engine>& /*to*/) {}
#endif
#ifndef HAS_BOX2D
void add_box2d(std::vector<Engine>& /*to*/) {}
#endif
#ifndef HAS_MUJOCO
void add_mujoco(std::vector<Engine>& /*to*/) {}
#endif

}  // namespace bounce::report
