#include "stages/scene_simulations.hpp"

namespace bounce {

template class RunOf<OneBallWorld<SpringFloor, SpringFloorExact>>;
template class RunOf<OneBallWorld<Damping, DampingExact>>;
template class RunOf<OneBallWorld<OscillatingFloor, OscillatingFloorExact>>;

}  // namespace bounce
