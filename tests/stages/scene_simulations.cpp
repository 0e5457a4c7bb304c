#include "stages/scene_simulations.hpp"

namespace bounce {

template class RunOf<OneBallWorld<SpringFloor, SpringFloorExact>>;
template class RunOf<OneBallWorld<Damping, DampingExact>>;
template class RunOf<OneBallWorld<ThreeDimensions, ThreeDimensionsExact>>;
template class RunOf<OneBallWorld<OscillatingFloor, OscillatingFloorExact>>;
template class RunOf<OneBallWorld<TiltedPlane, TiltedPlaneExact>>;

}  // namespace bounce
