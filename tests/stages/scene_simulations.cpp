#include "stages/scene_simulations.hpp"

namespace bounce {

template class SceneSimulation<SpringFloor, SpringFloorExact>;
template class SceneSimulation<Damping, DampingExact>;
template class SceneSimulation<OscillatingFloor, OscillatingFloorExact>;

}  // namespace bounce
