#include "stages/scene_simulations.hpp"

namespace bounce {

template class SceneSimulation<ThreeDimensions, ThreeDimensionsExact>;
template class SceneSimulation<TiltedPlane, TiltedPlaneExact>;

}  // namespace bounce
