#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "speed_vs_error/subjects.hpp"

namespace bounce::report {

/// A ball of 1 kg with a radius of 0.1 m over a fixed floor, in the hands of a rigid-body engine.
class EngineBall {
 public:
  virtual ~EngineBall() = default;
  virtual void drop() = 0;  // at rest, centre at 1 m
  virtual void step() = 0;
  virtual double height() const = 0;    // of the centre; m
  virtual double velocity() const = 0;  // upwards; m/s
};

/// What the ball does at the floor.
enum class Bounce {
  restitution,      // it comes back at once with a fixed share of its speed
  push_only_spring  // the course's spring and damper with contact=push-only
};

struct Engine {
  std::string name, version;
  Bounce bounce;
  std::function<std::unique_ptr<EngineBall>(double dt, double restitution)> make;
};

/// The case "engines": the damped ball (b) as rigid-body engines see it, and the course's own loop
/// at the same time steps. Each row is judged by the exact solution of its own model.
Case engines_case();

/// "Bullet 3.24, ODE 0.16.2", or "none".
std::string engine_versions();

/// Each adds its engine, where it was installed when CMake looked (peers_*.cpp).
void add_bullet(std::vector<Engine>& to);
void add_ode(std::vector<Engine>& to);
void add_box2d(std::vector<Engine>& to);
void add_mujoco(std::vector<Engine>& to);

}  // namespace bounce::report
