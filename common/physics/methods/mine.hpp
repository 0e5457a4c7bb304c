#pragma once
#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

// `./course play N --mine` compiles a stage on a learner's lines, and writes this header into a
// folder of its own: it includes the learner's loop of stage 1 (BOUNCE_MY_LOOP), and the learner's
// method, mine_method.hpp (BOUNCE_MY_METHOD), where these are written.
#ifdef BOUNCE_MINE
#include "mine/loop.hpp"
#endif

namespace bounce {

/// A list of method objects (method.hpp).
template <class... Methods>
struct MethodList {};

template <class... A, class... B>
MethodList<A..., B...> operator+(MethodList<A...>, MethodList<B...>);

// A learner's own lines are a method like any other, and the first choice where they are written.
// `mine` is the method, if there is one; else it is the loop of stage 1.
namespace methods {
#ifdef BOUNCE_MY_METHOD
/// Its order is what `./course check loop` measures: nothing here depends on it.
inline constexpr Method mine{
    .name = "mine", .about = "your own method, mine_method.hpp", .order = 0, .evaluations = 0};
#endif
#ifdef BOUNCE_MY_LOOP
inline constexpr Method my_loop{
#ifdef BOUNCE_MY_METHOD
    .name = "my-loop",
#else
    .name = "mine",
#endif
    .about = "your own loop of stage 1",
    .order = 1,
    .evaluations = 1,
    .stability_limit = semi_implicit_euler_limit};
#endif
}  // namespace methods

#ifdef BOUNCE_MY_LOOP
struct MyLoop {
  static constexpr Method facts = methods::my_loop;

  template <class Scene, class Vector>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    fall_one_step(scene, t, state, dt);
  }
};
using MyLoops = MethodList<MyLoop>;
#else
using MyLoops = MethodList<>;
#endif

#ifdef BOUNCE_MY_METHOD
/// The learner's method. What it costs is not said but counted.
template <class Vector>
struct MyCountedMethod {
  static constexpr Method facts = methods::mine;

  MyMethod<Vector> method;
  long long evaluations = 0;

  template <class Scene>
  struct Counted {
    const Scene& scene;
    long long& evaluations;
    decltype(auto) acceleration(double t, const State<Vector>& state) const {
      ++evaluations;
      return scene.acceleration(t, state);
    }
  };

  template <class Scene>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    method(Counted<Scene>{scene, evaluations}, t, state, dt);
  }
  long long counted_evaluations() const { return evaluations; }
  /// Nothing that was remembered holds any more.
  void forget() { method = {}; }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    if constexpr (requires { self.method.remembered(self.method, visit); }) {
      self.method.remembered(self.method, visit);
    }
  }
};
template <class Vector>
using MyMethods = decltype(MethodList<MyCountedMethod<Vector>>{} + MyLoops{});
#else
template <class Vector>
using MyMethods = MyLoops;
#endif

}  // namespace bounce
