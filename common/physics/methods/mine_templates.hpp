#pragma once
#include <tuple>

#include "physics/methods/mine.hpp"

namespace bounce {

/// What a learner wrote as templates, for one scene: in a program whose other files were compiled
/// before, this is where they become code. `Scene::acceleration` tells what a position is.
template <class Scene, class Answer, class Vector>
constexpr auto my_templates(Answer (Scene::*)(double, const State<Vector>&) const) {
  return std::tuple{
#ifdef BOUNCE_MY_METHOD
      &MyMethod<Vector>::template
      operator()<typename MyCountedMethod<Vector>::template Counted<Scene>>,
#endif
#ifdef BOUNCE_MY_LOOP
      &fall_one_step<Scene, Vector>,
#endif
      0};
}

}  // namespace bounce
