// What the exact solution costs: CPU time per simulated second of cases (a) and (b), final state
// only. usage: exact_cost

#include <cstdio>

#include "03_damping/exact.hpp"
#include "physics/event_driven.hpp"
#include "speed_vs_error/stopwatch.hpp"

using namespace bounce;

namespace {

report::Work fly_to(double t_end, double damping, ContactLaw law) {
  return [=](long n) {
    double sum = 0;
    Damping scene;
    scene.damping = damping;
    scene.contact = law;
    for (long i = 0; i < n; ++i) {
      scene.start.position = 1 + 1e-13 * static_cast<double>(i % 7);  // no two runs in a row alike
      EventDriven<DampingExact> walker(DampingExact(scene), 0, scene.start);
      sum += walker.at(t_end).position;
    }
    return sum;
  };
}

}  // namespace

int main() {
  const auto cost = report::cost_in_alternation(
      {fly_to(10, 0, ContactLaw::slides), fly_to(5, 5, ContactLaw::slides),
       fly_to(5, 5, ContactLaw::push_only)},
      15, 0.02);
  std::printf("us per simulated second:\n(a) no damping, 10 s      %.4f\n", cost[0] / 10 * 1e6);
  std::printf("(b) damping 5, 5 s        %.4f\n(b) the same, push-only   %.4f\n", cost[1] / 5 * 1e6,
              cost[2] / 5 * 1e6);
}
