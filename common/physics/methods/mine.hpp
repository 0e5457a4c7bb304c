#pragma once
#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

// `./course play N --mine` compiles a stage on a learner's lines, and writes this header into a
// folder of its own: it includes the learner's loop of stage 1 and defines BOUNCE_MY_LOOP, if that
// is written.
#ifdef BOUNCE_MINE
#include "mine/loop.hpp"
#endif

namespace bounce {

/// A list of method objects (method.hpp).
template <class... Methods>
struct MethodList {};

/// A learner's own loop is a method like any other, and the first choice where it is written.
#ifdef BOUNCE_MY_LOOP
namespace methods {
inline constexpr Method mine{.name = "mine",
                             .about = "your own loop of stage 1",
                             .order = 1,
                             .evaluations = 1,
                             .stability_limit = semi_implicit_euler_limit};
}  // namespace methods

struct MyLoop {
  static constexpr Method facts = methods::mine;

  template <class Scene, class Vector>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    fall_one_step(scene, t, state, dt);
  }
};
using MyMethods = MethodList<MyLoop>;
#else
using MyMethods = MethodList<>;
#endif

}  // namespace bounce
