// What a bounce on the shaken floor costs in a sweep: by the exact solution, by quick bounces of
// one ball, and by those of four balls side by side. 400 amplitudes from 0.05 to 0.09 m at 2 Hz,
// 100 bounces after 300 each; CPU time, medians in alternation. usage: sweep_speed [ROUNDS]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "speed_vs_error/stopwatch.hpp"

using namespace bounce;

namespace {

constexpr int discarded = 300, kept = 100;

std::vector<OscillatingFloor> sweep(ContactLaw contact) {
  std::vector<OscillatingFloor> scenes(400);
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    scenes[n].contact = contact;
    scenes[n].angular_frequency = 4 * std::numbers::pi;
    scenes[n].amplitude = 0.05 + 0.04 * static_cast<double>(n) / 399;
  }
  return scenes;
}

double exactly(const std::vector<OscillatingFloor>& scenes) {
  double sum = 0;
  for (const OscillatingFloor& scene : scenes) {
    SettlingBall ball{scene};
    for (int n = 0; n < discarded + kept; ++n) ball.bounce_exactly();
    for (int n = discarded; n < std::ssize(ball.bounces); ++n) sum += ball.bounces[n].height;
  }
  return sum;
}

double one_by_one(const std::vector<OscillatingFloor>& scenes) {
  double sum = 0;
  for (const OscillatingFloor& scene : scenes) {
    for (const Bounce& bounce : settled_bounces(scene, discarded, kept)) sum += bounce.height;
  }
  return sum;
}

double side_by_side(const std::vector<OscillatingFloor>& scenes) {
  double sum = 0;
  for (const std::vector<Bounce>& bounces : settled_bounces(scenes, discarded, kept)) {
    for (const Bounce& bounce : bounces) sum += bounce.height;
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
  std::printf("%s\n", report::processor().c_str());
  for (const ContactLaw contact : {ContactLaw::may_pull, ContactLaw::push_only}) {
    const std::vector<OscillatingFloor> scenes = sweep(contact);
    if (one_by_one(scenes) != side_by_side(scenes)) {
      std::printf("side by side they are not the same\n");
      return 1;
    }
    std::vector<report::Work> works;
    for (const auto way : {exactly, one_by_one, side_by_side}) {
      works.push_back([way, &scenes](long n) {
        double sum = 0;
        for (long i = 0; i < n; ++i) sum += way(scenes);
        return sum;
      });
    }
    const std::vector<double> cost = report::cost_in_alternation(works, rounds, 0.2);
    const double bounces = static_cast<double>(scenes.size()) * (discarded + kept);
    const char* names[] = {"exact solution", "quick, one ball", "quick, four side by side"};
    std::printf("%s\n", contact == ContactLaw::may_pull ? "may-pull" : "push-only");
    for (std::size_t i = 0; i < works.size(); ++i) {
      std::printf("  %-26s %.3f us a bounce, %.2f million a second, %.2f times as fast\n", names[i],
                  cost[i] / bounces * 1e6, bounces / cost[i] / 1e6, cost[0] / cost[i]);
    }
  }
}
