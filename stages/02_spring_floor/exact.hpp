#pragma once
#include "02_spring_floor/spring_floor.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

/// Stage 2 in closed form: parabolas, and half swings of an undamped oscillator between them.
struct SpringFloorExact : BouncePhases {
  explicit SpringFloorExact(const SpringFloor& scene)
      : BouncePhases{scene.mass, scene.gravity, scene.radius, {scene.stiffness, 0}} {}
};

}  // namespace bounce
