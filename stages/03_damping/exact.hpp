#pragma once
#include "03_damping/damping.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

/// Stage 3 in closed form: parabolas, and swings of a damped oscillator between them.
struct DampingExact : BouncePhases {
  explicit DampingExact(const Damping& scene)
      : BouncePhases{scene.mass,
                     scene.gravity,
                     scene.radius,
                     {scene.stiffness, scene.damping, scene.contact}} {}
};

}  // namespace bounce
