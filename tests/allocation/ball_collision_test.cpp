// A step of many balls allocates nothing. This program is built by itself, because it makes Eigen
// watch its own memory (which it does not take from operator new).

#include <cstdlib>
#include <new>
#include <stdexcept>

#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition) \
  if (!(condition)) throw std::logic_error(#condition)

#include <doctest/doctest.h>

#include "05_ball_collision/scenes.hpp"
#include "physics/integrators.hpp"

using namespace bounce;

static long long allocations = 0;

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

TEST_CASE("stage 5: a step allocates nothing, with the double loop and with the grid") {
  using Balls = State<Eigen::Matrix3Xd>;
  for (const int count : {3, 40, 200}) {
    for (const bool verlet : {false, true}) {
      CAPTURE(count);
      CAPTURE(verlet);
      const Arrangement start = drop(count, 0.0143, {0.6, 0.6}, 1);
      BallCollision scene;
      scene.mass = start.mass;
      scene.radius = start.radius;
      scene.tray = {0.6, 0.6};
      scene.damping = scene.floor_damping = 20;
      Balls state = start.balls;
      VelocityVerlet<Eigen::Matrix3Xd> carried;
      const auto steps = [&](int how_many) {
        for (int i = 0; i < how_many; ++i) {
          if (verlet) carried(scene, 0, state, 1e-3);
          if (!verlet) semi_implicit_euler(scene, 0, state, 1e-3);
        }
      };
      steps(2);  // the buffers get their size
      const long long before = allocations;
      Eigen::internal::set_is_malloc_allowed(false);
      CHECK_NOTHROW(steps(1000));
      Eigen::internal::set_is_malloc_allowed(true);
      CHECK(allocations == before);
    }
  }
}
