// A step of many balls allocates nothing. This program is built by itself, because it makes Eigen
// watch its own memory (which it does not take from operator new).

#include <cstdlib>
#include <new>
#include <stdexcept>

#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition) \
  if (!(condition)) throw std::logic_error(#condition)

#include <doctest/doctest.h>

#include "05_ball_collision/scenes/scenes.hpp"
#include "many_balls/many_balls.hpp"
#include "physics/methods/stepping_methods.hpp"

using namespace bounce;

static long long allocations = 0;

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using Balls = State<Eigen::Matrix3Xd>;

TEST_CASE("stage 5: a step allocates nothing, with the double loop and with the grid") {
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

TEST_CASE("stage 5: the fast path allocates nothing in a step, and in a list only what is new") {
  const int count = 300;
  const std::array<double, 2> tray{tray_for(count), tray_for(count)};
  const Arrangement start = drop(count, 0.0143, tray, 1);
  const many::Laws laws{9.81, {2e4, 20}, {2e4, 20}, true, tray};
  many::ManyBalls fast;
  Balls state = start.balls;
  Eigen::Matrix3Xd acceleration;
  const auto steps = [&](int how_many) {
    fast.move(laws, start.mass, start.radius, state, acceleration, many::Stepping::velocity_verlet,
              how_many, 2e-4);
  };
  steps(6000);  // they have fallen, and the lists have their size
  const long long before = allocations, lists = fast.lists_built();
  Eigen::internal::set_is_malloc_allowed(false);
  CHECK_NOTHROW(steps(1000));
  Eigen::internal::set_is_malloc_allowed(true);
  CHECK(allocations == before);
  CHECK(fast.lists_built() > lists);
}
