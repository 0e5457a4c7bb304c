// The other half of all_stages.cpp, so that two processors can compile it.

#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "run/scene_simulation.hpp"

namespace bounce {

template class SceneSimulation<ThreeDimensions, ThreeDimensionsExact>;
template class SceneSimulation<TiltedPlane, TiltedPlaneExact>;

}  // namespace bounce
