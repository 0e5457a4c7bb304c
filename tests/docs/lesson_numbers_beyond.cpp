// The plan for a billion balls, in numbers that follow from a few measured ones
// (docs/beyond_one_machine.md).

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>

#include "docs/tables.hpp"

namespace {

// Measured (the tables of the page), or data sheets of the year 2020:
constexpr double ns_per_ball_and_step = 100;  // one core, with room for a slower one
constexpr double bytes_per_ball = 400;        // the limit of our memory for one ball
constexpr double network = 10e9;              // bytes/s, each way, of one process's share
constexpr double latency = 2e-6;              // s for one message

constexpr double balls = 1e9, radius = 0.05, packing = 0.6, skin = 0.01;
constexpr double bytes_per_ghost = 6 * 8;  // position and velocity

void row(double processes) {
  const double each = balls / processes;
  const double volume = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) / packing;
  const double edge = std::cbrt(each * volume);  // m, of a cube
  const double reach = 2 * radius + skin;
  const double ghosts = (std::pow(edge + 2 * reach, 3) - std::pow(edge, 3)) / volume;
  const double computing = each * ns_per_ball_and_step * 1e-9;
  // Six messages, one over each face; those that come first are passed on around the corners.
  const double talking = ghosts * bytes_per_ghost / network + 6 * latency;
  // Once a step all must know the fastest ball: a tree, up and down.
  const double agreeing = 2 * std::log2(processes) * latency;
  std::printf("| %.0f | %.0f | %.3g GB | %.2g %% | %.2g MB | %.3g ms | %.2g ms | %.2g ms |\n",
              processes, each, each * bytes_per_ball / 1e9, 100 * ghosts / each,
              ghosts * bytes_per_ghost / 1e6, computing * 1e3, talking * 1e3, agreeing * 1e3);
}

void domains() {
  std::printf(
      "| processes | balls each | memory each | ghosts | sent each step | computing | sending | "
      "agreeing |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const double processes : {64.0, 1000.0, 10000.0, 100000.0}) row(processes);
}

struct Count {
  double count;
  const char* name;
};

/// How hard the lowest ball is pressed: it carries a column as high as the heap, and the overlap is
/// the weight over the stiffness.
void heap() {
  const double g = 9.81, mass = 1;
  std::printf(
      "| balls | height of the heap | balls above each other | overlap at k = 1e5 | k for 1 %% of "
      "r | dt |\n"
      "|---|---|---|---|---|---|\n");
  for (const auto& [count, name] :
       {Count{1e3, "a thousand"}, {1e6, "a million"}, {1e9, "a billion"}}) {
    const double volume = count * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) / packing;
    const double height = std::cbrt(2 * volume) / 2;  // the tray is twice as wide as high
    const double above = height / (2 * radius);
    const double weight = above * mass * g;
    const double k = weight / (0.01 * radius);
    std::printf("| %s | %.2g m | %.0f | %.2g mm | %.1e N/m | %.1e s |\n", name, height, above,
                1e3 * weight / 1e5, k, 1e-4 * std::sqrt(1e5 / k));
  }
}

const bounce::test::Table tables[] = {{"domains", domains}, {"heap", heap}};

}  // namespace

int main(int argc, char** argv) { return bounce::test::print_table(tables, argc, argv); }
