#include "stages/scene_simulations.hpp"

namespace bounce {

template class RunOf<OneBallWorld<ThreeDimensions, ThreeDimensionsExact>>;
template class RunOf<OneBallWorld<TiltedPlane, TiltedPlaneExact>>;

}  // namespace bounce
