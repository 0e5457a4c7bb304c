#pragma once
#include "physics/events/whole_law.hpp"
#include "physics/methods/reference.hpp"

namespace bounce {

/// `reference` for a scene without closed forms.
template <class Scene, class Vector>
struct WholeLawReference : ReferenceMethod<WholeLaw<Scene, Vector>, Vector> {
  static constexpr Method facts{.name = methods::reference.name,
                                .about = "the whole law by DOP853 within --tolerance",
                                .order = methods::reference.order,
                                .evaluations = 0,
                                .goes_by_events = true};
  using ReferenceMethod<WholeLaw<Scene, Vector>, Vector>::ReferenceMethod;
};

}  // namespace bounce
