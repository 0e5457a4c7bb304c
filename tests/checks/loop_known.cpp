#include "checks/loop_known.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "checks/judge.hpp"
#include "checks/walk_with.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::check {

namespace {

using Ball = State<double>;
using Scene = const CountedLaw&;

/// Each walk begins with a fresh copy of the step, and what that remembers.
template <class Step>
KnownMethod known(const char* name, Step step, const char* says = "") {
  return {name, says, [step](const Walk& walk) {
            Step fresh = step;
            return walk_with(fresh, walk);
          }};
}

/// A step that asks twice, in numbers. With a1 at (t, y, v), or remembered from the last step's a2:
///   a2 at   t + when dt,   y + (drift v + bend a1 dt) dt,   v + kick a1 dt
///   y += (move v + (y1 a1 + y2 a2) dt) dt,   v += (v1 a1 + v2 a2) dt
struct TwoSlopes {
  double when, drift, bend, kick, move, y1, y2, v1, v2;
  bool remembers = false;
  std::optional<double> kept = {};

  void operator()(Scene scene, double t, Ball& s, double dt) {
    if (!kept || !remembers) kept = scene.acceleration(t, s);
    const double a1 = *kept;
    const bool asks_again = y2 != 0 || v2 != 0;
    if (asks_again) {
      const double y = s.position + (drift * s.velocity + bend * a1 * dt) * dt;
      kept = scene.acceleration(t + when * dt, {y, s.velocity + kick * a1 * dt});
    }
    s.position += (move * s.velocity + (y1 * a1 + y2 * *kept) * dt) * dt;
    s.velocity += (v1 * a1 + v2 * *kept) * dt;
  }
};

/// The classical Runge-Kutta method: `sum` is 6; `moves` is 1: whether time goes on in the step.
struct FourSlopes {
  double sum, moves;

  void operator()(Scene scene, double t, Ball& s, double dt) const {
    Ball slope{0, 0}, all{0, 0};
    for (const auto& [ahead, weight] : {std::pair{0.0, 1}, {0.5, 2}, {0.5, 2}, {1.0, 1}}) {
      const double h = ahead * dt;
      const Ball there{s.position + h * slope.position, s.velocity + h * slope.velocity};
      slope = {there.velocity, scene.acceleration(t + moves * h, there)};
      all.position += weight * slope.position;
      all.velocity += weight * slope.velocity;
    }
    s.position += all.position * dt / sum;
    s.velocity += all.velocity * dt / sum;
  }
};

/// Velocity Verlet that does not ask while the acceleration stays as it was.
struct AsksWhileItChanges {
  std::optional<double> old = {}, now = {};

  void operator()(Scene scene, double t, Ball& s, double dt) {
    if (!now) now = scene.acceleration(t, s);
    const double before = *now;
    s.velocity += before * dt / 2;
    s.position += s.velocity * dt;
    if (!old || before != *old) now = scene.acceleration(t + dt, s);
    old = before;
    s.velocity += *now * dt / 2;
  }
};

bool same(const Walked& one, const Walked& other) {
  const auto close = [](double a, double b) { return std::abs(a - b) < 1e-11 * (1 + std::abs(b)); };
  if (one.states.size() != other.states.size()) return false;
  for (std::size_t i = 0; i < one.states.size(); ++i) {
    if (!close(one.states[i].y, other.states[i].y)) return false;
    if (!close(one.states[i].v, other.states[i].v)) return false;
  }
  return true;
}

}  // namespace

const std::vector<KnownMethod>& built_in_methods() {
  static const std::vector<KnownMethod> all{known("velocity Verlet", VelocityVerlet<double>{}),
                                            known("RK4", Rk4{})};
  return all;
}

const std::vector<KnownMethod>& methods_of_textbooks() {
  static const std::vector<KnownMethod> all{
      known("the midpoint method", TwoSlopes{.5, .5, 0, .5, 1, .5, 0, 0, 1}),
      known("Heun's method", TwoSlopes{1, 1, 0, 1, 1, .5, 0, .5, .5}),
      known("position Verlet", TwoSlopes{.5, .5, 0, 0, 1, 0, .5, 0, 1})};
  return all;
}

const std::vector<KnownMethod>& usual_mistakes() {
  static const char* const kick_forgotten =
      "the velocity changes by half of what it should. A step has two kicks of dt / 2: one before "
      "the move, one after it.";
  static const char* const middle_is_end =
      "the way to the middle of the step takes dt / 2, and yours a whole dt.";
  static const char* const time_stands_still =
      "every acceleration is asked for at the time t. That of the middle belongs to t + dt / 2, "
      "and that of the end to t + dt: a force may depend on the time.";
  static const std::vector<KnownMethod> all{
      known("position before velocity", TwoSlopes{0, 0, 0, 0, 1, 0, 0, 1, 0},
            "the position moved with the velocity from before the step, and the velocity with the "
            "acceleration from there. That is explicit Euler, of order 1."),
      known("the loop of stage 1", TwoSlopes{0, 0, 0, 0, 1, 1, 0, 1, 0},
            "it is right, and of order 1. A better one moves with the velocity of the middle of "
            "the step: half a kick, the move, half a kick."),
      known("half a kick forgotten", TwoSlopes{0, 0, 0, 0, 1, .5, 0, .5, 0}, kick_forgotten),
      known("half a kick forgotten", TwoSlopes{1, 1, 0, 0, 1, 0, 0, 0, .5}, kick_forgotten),
      known("dt / 2 twice", TwoSlopes{1, .5, .25, .5, .5, .25, 0, .5, .5},
            "the position moves for half of the dt only. The kicks are halves, the move is whole."),
      known("dt / 2 twice", TwoSlopes{1, 1, .25, .25, 1, .25, 0, .25, .25},
            "the velocity changes by half of what it should: two kicks of a quarter."),
      known("dt / 2 twice", TwoSlopes{.5, .5, 0, .5, .5, .25, 0, 0, .5},
            "the middle is only where the slope comes from. The step itself is a whole dt."),
      known("a middle that is the end", TwoSlopes{.5, 1, 0, 1, 1, 1, 0, 0, 1}, middle_is_end),
      known("a middle that is the end", TwoSlopes{1, 1, 0, 1, 1, 1, 0, 0, 1}, middle_is_end),
      known("the old velocity", TwoSlopes{.5, .5, 0, .5, 1, 0, 0, 0, 1},
            "the velocity takes its change from the middle of the step, and the position does not: "
            "it moves with the velocity of the beginning."),
      known("a sum in place of a mean", TwoSlopes{1, 1, 0, 1, 2, 1, 0, 1, 1},
            "two accelerations are added, and so are two velocities. Their mean is half of that."),
      known("weights that are too heavy", FourSlopes{4, 1},
            "1 + 2 + 2 + 1 slopes are 6 of them. Divide by 6: dt / 6."),
      known("the old acceleration", TwoSlopes{0, 0, 0, 0, 1, .5, 0, 1, 0},
            "the acceleration of the beginning is used for the second half of the step, too. Ask "
            "for a new one, after the move."),
      known("asked once, and never again", TwoSlopes{0, 0, 0, 0, 1, .5, 0, 1, 0, true},
            "what your method remembers is never renewed: acceleration = scene.acceleration(...) "
            "in each step."),
      known("time stands still", TwoSlopes{0, 1, .5, .5, 1, .5, 0, .5, .5}, time_stands_still),
      known("time stands still", TwoSlopes{0, 1, .5, .5, 1, .5, 0, .5, .5, true},
            time_stands_still),
      known("time stands still", TwoSlopes{0, .5, 0, .5, 1, .5, 0, 0, 1}, time_stands_still),
      known("time stands still", TwoSlopes{0, 1, 0, 1, 1, .5, 0, .5, .5}, time_stands_still),
      known("time stands still", FourSlopes{6, 0}, time_stands_still),
      known("not asked in the air", AsksWhileItChanges{},
            "while the acceleration stays as it was, you do not ask for it: so nobody notices the "
            "floor. Ask in each step."),
  };
  return all;
}

bool is_twin(const KnownMethod& known, bool with_damper) {
  const double c = with_damper ? 0.7 : 0;
  const auto curved = [c](double t, double y, double v) {
    return 2 * std::cos(3 * t) - 4 * std::sin(2 * y) - c * v;
  };
  // Falls for a while, and then on a floor that begins at 0.
  const auto floor = [c](double, double y, double v) { return -1 + (y < 0 ? -9 * y - c * v : 0); };
  for (const Walk& walk :
       {Walk{curved, 0.4, 0.3, 0.8, 0.05, 60, 1}, Walk{curved, 1.1, -0.6, 0.2, 0.02, 60, 1},
        Walk{floor, 0, 0.5, 0.1, 0.05, 60, 1}}) {
    if (!same(subject().walk(walk), known.walk(walk))) return false;
  }
  return true;
}

const KnownMethod* find_twin(const std::vector<KnownMethod>& all) {
  for (const KnownMethod& known : all) {
    if (is_twin(known, false)) return &known;
  }
  return nullptr;
}

}  // namespace bounce::check
