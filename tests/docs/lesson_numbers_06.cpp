// The tables of numbers of stage 6, computed with the library. usage: lesson_numbers_06 TABLE
// Its pages show them after <!-- table: lesson_numbers_06 TABLE --> (lesson_tool.hpp).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "06_oscillating_floor/sweep/settled_bounces.hpp"
#include "docs/tables.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/stepping_methods.hpp"

using namespace bounce;

namespace {

using Walker = EventDriven<OscillatingFloorExact>;

Walker exact_of(const OscillatingFloor& scene) {
  return Walker(OscillatingFloorExact(scene), 0, scene.start);
}

/// The scene of the sections on bounces that double: 2 Hz, and a contact that only pushes.
OscillatingFloor two_hertz(double amplitude) {
  OscillatingFloor scene;
  scene.contact = ContactLaw::push_only;
  scene.angular_frequency = 4 * std::numbers::pi;
  scene.amplitude = amplitude;
  return scene;
}

/// How fast the ball leaves a floor in uniform motion, seen from it, per speed at which it came.
void moving_floor() {
  std::printf("| floor [m/s] | `relative` | `absolute` |\n|---|---|---|\n");
  for (const double u : {-4.0, -2.0, 0.0, 2.0, 4.0}) {
    std::printf("| %+.0f ", u);
    for (const FloorLaw law : {FloorLaw::relative, FloorLaw::absolute}) {
      OscillatingFloor scene;
      scene.mass = 0.37;
      scene.gravity = 0;
      scene.stiffness = 812.3;
      scene.damping = 2.9;
      scene.amplitude = 0;
      scene.floor_velocity = u;
      scene.floor_law = law;
      scene.start = {0.2, u - 4.7};
      Walker walker = exact_of(scene);
      while (walker.next_event() != never) walker.pass_event();
      std::printf("| %.6f ", (walker.state_at_last_event().velocity - u) / 4.7);
    }
    std::printf("|\n");
  }
}

/// From which amplitude on a ball at rest leaves a floor whose swing starts suddenly.
void sudden() {
  std::printf(
      "| frequency [rad/s] | g / w^2 [mm] | sudden start: flies from [mm] |\n|---|---|---|\n");
  for (const double w : {6.3, 12.6, 25.0}) {
    OscillatingFloor scene;
    scene.angular_frequency = w;
    scene.start = {scene.radius - scene.mass * scene.gravity / scene.stiffness, 0};
    const double limit = scene.gravity / (w * w);
    double stays = 0, flies = limit;
    while (flies - stays > 1e-7) {
      scene.amplitude = (stays + flies) / 2;
      Walker walker = exact_of(scene);
      bool flown = false;
      while (walker.next_event() < 10 && !flown) {
        walker.pass_event();
        flown = walker.phase() == Phase::flight;
      }
      (flown ? flies : stays) = scene.amplitude;
    }
    std::printf("| %g | %.1f | %.1f |\n", w, 1e3 * limit, 1e3 * flies);
  }
}

/// A row: the different heights among the last of many bounces.
void heights_of(const OscillatingFloor& scene) {
  std::vector<double> all;
  for (const Bounce& bounce : settled_bounces(scene, 600, 64)) {
    const auto same = [&](double h) { return std::abs(h - bounce.height) < 1e-4; };
    if (std::none_of(all.begin(), all.end(), same)) all.push_back(bounce.height);
  }
  std::rotate(all.begin(), std::min_element(all.begin(), all.end()), all.end());
  std::printf("| %g |", 1e3 * scene.amplitude);
  if (all.size() > 8) {
    std::printf(" %s 30 different ones in 64 bounces", all.size() > 30 ? "more than" : "at most");
  } else {
    for (const double height : all) std::printf(" %.3f", height);
  }
  std::printf(" |\n");
}

void heights() {
  std::printf("| amplitude [mm] | heights in turn [m] |\n|---|---|\n");
  for (const double amplitude : {0.056, 0.062, 0.068, 0.074, 0.0765, 0.082}) {
    OscillatingFloor scene = two_hertz(amplitude);
    // From 0.8 m the way to the four heights leads through chaos, where the last digit of a sine
    // decides when it ends; from 0.82 m it does not.
    if (amplitude == 0.0765) scene.start.position = 0.82;
    heights_of(scene);
  }
}

/// The same with all that the demo begins with, but the amplitude.
void default_heights() {
  std::printf("| amplitude [mm] | heights in turn [m] |\n|---|---|\n");
  for (const double amplitude : {0.060, 0.065, 0.070, 0.075, 0.082}) {
    OscillatingFloor scene;
    scene.amplitude = amplitude;
    heights_of(scene);
  }
}

/// When two balls that start 1 um apart are 1 mm, 1 cm and 10 cm apart.
void parting_of(const std::vector<OscillatingFloor>& scenes) {
  std::printf("| amplitude [mm] | 1 mm apart after | 1 cm | 10 cm |\n|---|---|---|---|\n");
  for (const OscillatingFloor& scene : scenes) {
    OscillatingFloor twin = scene;
    twin.start.position += 1e-6;
    Walker a = exact_of(scene), b = exact_of(twin);
    double t = 0;
    std::printf("| %.0f ", 1e3 * scene.amplitude);
    for (const double distance : {1e-3, 1e-2, 1e-1}) {
      while (t < 60 && std::abs(a.at(t).position - b.at(t).position) < distance) t += 0.01;
      if (t < 60) {
        std::printf("| %.1f s ", t);
      } else {
        std::printf("| not in 60 s ");
      }
    }
    std::printf("|\n");
  }
}

void parting() {
  parting_of({two_hertz(0.062), two_hertz(0.070), two_hertz(0.082), two_hertz(0.090)});
}

/// The same with all that the demo begins with, but the amplitude.
void default_parting() {
  OscillatingFloor scene;
  scene.amplitude = 0.082;
  parting_of({scene});
}

/// Mean and spread of the ball's height over 4000 s, at 0.1 s intervals.
template <class Advance>
void statistics(const char* name, const Advance& height_at) {
  constexpr int samples = 40000;
  double sum = 0, squares = 0;
  int high = 0;
  for (int i = 1; i <= samples; ++i) {
    const double y = height_at(0.1 * i);
    sum += y;
    squares += y * y;
    high += y > 0.8;
  }
  const double mean = sum / samples;
  std::printf("| %s | %.3f | %.3f | %.1f %% |\n", name, mean,
              std::sqrt(squares / samples - mean * mean), 100.0 * high / samples);
}

void trust_of(const OscillatingFloor& scene) {
  std::printf("| run | mean height [m] | spread [m] | time above 0.8 m |\n|---|---|---|---|\n");
  OscillatingFloor twin = scene;
  twin.start.position += 1e-6;
  Walker a = exact_of(scene), b = exact_of(twin);
  statistics("`exact`", [&](double t) { return a.at(t).position; });
  statistics("`exact`, from 1 um higher", [&](double t) { return b.at(t).position; });
  for (const int per_sample : {1000, 100}) {
    State<double> state = scene.start;
    const double dt = 0.1 / per_sample;
    const auto stepped = [&](double t) {
      for (int i = 0; i < per_sample; ++i) {
        semi_implicit_euler(scene, t - 0.1 + i * dt, state, dt);
      }
      return state.position;
    };
    const std::string name = "semi-implicit Euler, dt = " + to_text(dt) + " s";
    statistics(name.c_str(), stepped);
  }
}

void trust() { trust_of(two_hertz(0.082)); }

void default_trust() {
  OscillatingFloor scene;
  scene.amplitude = 0.082;
  trust_of(scene);
}

/// Position error after 1.5 s, root mean square over 100 random starts.
void error() {
  std::printf(
      "| dt [s], about | semi-implicit Euler | velocity Verlet | RK4 |\n|---|---|---|---|\n");
  for (const double about : {1e-3, 5e-4, 2.5e-4, 1.25e-4}) {
    std::printf("| %g ", about);
    for (int method = 0; method < 3; ++method) {
      std::mt19937_64 random(6);
      double squares = 0;
      constexpr int runs = 100;
      for (int n = 0; n < runs; ++n) {
        const auto lot = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
        OscillatingFloor scene = two_hertz(0.062);
        scene.start.position = 0.4 + 0.5 * lot();
        scene.phase = 6.283 * lot();
        const int steps = static_cast<int>(1.5 / (about * (0.9 + 0.2 * lot())));
        const double dt = 1.5 / steps;
        State<double> state = scene.start;
        VelocityVerlet<double> verlet;
        for (int i = 0; i < steps; ++i) {
          if (method == 0) semi_implicit_euler(scene, i * dt, state, dt);
          if (method == 1) verlet(scene, i * dt, state, dt);
          if (method == 2) rk4(scene, i * dt, state, dt);
        }
        const double off = state.position - exact_of(scene).at(1.5).position;
        squares += off * off / runs;
      }
      std::printf("| %.1e ", std::sqrt(squares));
    }
    std::printf("|\n");
  }
}

const bounce::test::Table tables[] = {{"moving_floor", moving_floor},
                                      {"sudden", sudden},
                                      {"heights", heights},
                                      {"default_heights", default_heights},
                                      {"parting", parting},
                                      {"default_parting", default_parting},
                                      {"trust", trust},
                                      {"default_trust", default_trust},
                                      {"error", error}};

}  // namespace

int main(int argc, char** argv) { return bounce::test::print_table(tables, argc, argv); }
