#pragma once
#include <array>
#include <functional>
#include <vector>

namespace bounce::check {

// What is checked is somebody's stage: the course's own, a learner's, or one with a named mistake.
// It is compiled alone, into a module of its own, and the checks see it through this interface:
// plain numbers, no Eigen. So a learner waits for one small file only.

using Triple = std::array<double, 3>;  // x, y, z; stages in one dimension have y only

/// All that a scene can be told. A stage takes what it has a field for.
struct Setting {
  double mass = 1, gravity = 9.81, radius = 0.1, stiffness = 1e4, damping = 0;
  bool push_only = false;
  bool floor = true;                                                           // stage 4
  double amplitude = 0, angular_frequency = 0, phase = 0, floor_velocity = 0;  // stage 6
  int floor_law = 0;                                                           // stage 6
  Triple normal{0, 1, 0};                                                      // stage 7
  double offset = 0;                                                           // stage 7
  Triple centre{}, disc_normal{0, 1, 0}, disc_velocity{}, disc_spin{};         // stage 8
  double disc_radius = 0.3;                                                    // stage 8
  int side = 1;                                                                // stage 8
  double since = 0;                                                            // stage 8
  double floor_stiffness = 1e4, floor_damping = 0;                             // stage 5
  std::array<double, 4> own{};  // of a stage of your own (./course new): what its subject.cpp says
};

struct Motion {
  Triple position, velocity;  // m, m/s
};

/// An acceleration that no stage has, for a loop that claims to work with all of them.
struct LinearLaw {
  double constant, per_position, per_velocity, per_time;
  double operator()(double t, double y, double v) const {
    return constant + per_position * y + per_velocity * v + per_time * t;
  }
};

/// A law on a line, a = law(t, y, v) [m/s^2], and so many steps of a learner's method on it.
struct Walk {
  std::function<double(double, double, double)> law;
  double t = 0, y = 0, v = 0, dt = 0;
  long steps = 0;
  long every = 0;  // a state is noted after so many steps; 0: after the last one
};
struct Walked {
  struct Noted {
    double y, v;
  };
  std::vector<Noted> states;
  long long evaluations = 0;  // how often the law was asked
};

struct OneOfMany {  // stage 5
  Motion motion;
  double radius, mass;
};
struct MeetingFound {
  double overlap;
  Triple e12;
  double separation_speed;
};
struct NearestFound {  // stage 8
  Triple point, direction;
  double distance;
};

/// A stage under check. What a stage does not have stays as it is here.
class Subject {
 public:
  virtual ~Subject() = default;

  virtual Triple force(const Setting&, double /*t*/, const Motion&) const { return {}; }
  virtual Triple acceleration(const Setting&, double /*t*/, const Motion&) const { return {}; }
  /// So many steps of the slides' loop.
  virtual Motion run(const Setting&, const Motion& start, double /*dt*/, long /*steps*/) const {
    return start;
  }
  // Stage 1: the learner's own loop, once around.
  virtual Motion step(const LinearLaw&, double /*t*/, const Motion& now, double /*dt*/) const {
    return now;
  }
  // A better loop: the learner's own method, on a line, and in space with the law in each
  // direction.
  virtual Walked walk(const Walk&) const { return {}; }
  virtual Motion walk_in_space(const Walk&, const Motion& start) const { return start; }
  // Stage 5
  virtual MeetingFound meet(const OneOfMany&, const OneOfMany&) const { return {}; }
  virtual Triple pair_force(const Setting&, const OneOfMany&, const OneOfMany&) const { return {}; }
  virtual std::vector<Triple> accelerations(const Setting&, const std::vector<OneOfMany>&) const {
    return {};
  }
  // Stage 6
  virtual double floor_height(const Setting&, double /*t*/) const { return 0; }
  virtual double floor_speed(const Setting&, double /*t*/) const { return 0; }
  virtual bool touches(const Setting&, double /*y*/, double /*floor*/) const { return false; }
  virtual double damped_velocity(const Setting&, double /*t*/, double /*v*/) const { return 0; }
  // Stage 7: a, b, c, d with a normal of unit length
  virtual std::array<double, 4> plane(const Setting&) const { return {}; }
  // Stage 8
  virtual NearestFound nearest(const Setting&, const Triple& /*ball*/) const { return {}; }
  virtual int side_after(const Setting&, double /*t*/, const Triple& /*ball*/) const { return 0; }
};

}  // namespace bounce::check
