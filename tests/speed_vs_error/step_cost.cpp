// Does the library cost anything? The slides' bare loop and the library's step, on the same 1e8
// steps: the results must be equal to the bit, and the time (ratio of medians, in alternation)
// within 2 %. usage: step_cost [STEPS]      exit code 1 when the results differ or the ratio stays
// above 1.02

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "03_damping/damping.hpp"
#include "physics/methods/stepping_methods.hpp"

using namespace bounce;

namespace {

constexpr long chunk = 1000000;  // steps between two looks at the clock
constexpr double dt = 1e-5;

// The program of the slides, with nothing around it.
void bare_loop(const Damping& p, double& y, double& v, long steps) {
  const double m = p.mass, g = p.gravity, k = p.stiffness, c = p.damping, r = p.radius;
  double F, a;
  for (long i = 0; i < steps; ++i) {
    F = -m * g;
    if (y < r) F += k * (r - y) - c * v;
    a = F / m;
    v += a * dt;
    y += v * dt;
  }
}

void library_loop(const Damping& scene, State<double>& state, long steps) {
  for (long i = 0; i < steps; ++i)
    semi_implicit_euler(scene, static_cast<double>(i) * dt, state, dt);
}

template <class Work>
double seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
#ifdef NDEBUG
  constexpr long usual = 100000000;
#else
  constexpr long usual = 10000000;
#endif
  const long steps = argc > 1 ? std::atol(argv[1]) : usual;
  const Damping scene;
  for (int attempt = 1; attempt <= 4; ++attempt) {  // a shared machine has bad moments
    double y = scene.start.position, v = scene.start.velocity;
    State<double> state = scene.start;
    std::vector<double> bare, library;
    for (long done = 0; done < steps; done += chunk) {
      bare.push_back(seconds([&] { bare_loop(scene, y, v, chunk); }));
      library.push_back(seconds([&] { library_loop(scene, state, chunk); }));
    }
    if (y != state.position || v != state.velocity) {
      std::printf(
          "the results differ: bare loop y = %.17g v = %.17g, library y = %.17g v = %.17g\n", y, v,
          state.position, state.velocity);
      return 1;
    }
#ifndef NDEBUG
    std::printf("%ld steps: results equal to the bit (times mean nothing in this build)\n", steps);
    return 0;
#endif
    const double ratio = median(library) / median(bare);
    std::printf(
        "%ld steps: bare loop %.3f ns, library %.3f ns a step, ratio %.3f; results equal to the "
        "bit\n",
        steps, median(bare) / chunk * 1e9, median(library) / chunk * 1e9, ratio);
    if (ratio <= 1.02) return 0;
  }
  return 1;
}
