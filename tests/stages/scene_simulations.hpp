#pragma once
#include "01_free_fall/exact.hpp"
#include "01_free_fall/free_fall.hpp"
#include "02_spring_floor/exact.hpp"
#include "02_spring_floor/spring_floor.hpp"
#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "run/one_ball_run.hpp"

namespace bounce {

// Compiled once, in scene_simulations.cpp: each takes a second or two. (Free fall has no contact,
// and is small.)
extern template class RunOf<OneBallWorld<SpringFloor, SpringFloorExact>>;
extern template class RunOf<OneBallWorld<Damping, DampingExact>>;
extern template class RunOf<OneBallWorld<ThreeDimensions, ThreeDimensionsExact>>;
extern template class RunOf<OneBallWorld<OscillatingFloor, OscillatingFloorExact>>;
extern template class RunOf<OneBallWorld<TiltedPlane, TiltedPlaneExact>>;

}  // namespace bounce
