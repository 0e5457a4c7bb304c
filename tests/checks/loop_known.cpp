#include "checks/loop_known.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "checks/judge.hpp"
#include "checks/walk_with.hpp"
#include "physics/methods/stepping_methods.hpp"

namespace bounce::check {

namespace {

using S = State<double>;
using Scene = const CountedLaw&;

/// Each walk begins with a fresh copy of the step, and what that remembers.
template <class Step>
KnownMethod known(const char* name, Step step, const char* says = "") {
  return {name, says, [step](const Walk& walk) {
            Step fresh = step;
            return walk_with(fresh, walk);
          }};
}

/// Half a kick, a drift, half a kick; with other parts of dt it is one of the mistakes.
auto kicks(double first, double drift, double last, double last_at = 1) {
  return [=](Scene scene, double t, S& s, double dt) {
    s.velocity += scene.acceleration(t, s) * dt * first;
    s.position += s.velocity * dt * drift;
    s.velocity += scene.acceleration(t + last_at * dt, s) * dt * last;
  };
}

/// The step by the slope in a middle, `ahead` of the start, asked for at the time `when`.
auto middle(double ahead, double when, double whole = 1) {
  return [=](Scene scene, double t, S& s, double dt) {
    const double a = scene.acceleration(t, s);
    const S there{s.position + s.velocity * dt * ahead, s.velocity + a * dt * ahead};
    s.position += there.velocity * dt * whole;
    s.velocity += scene.acceleration(t + when * dt, there) * dt * whole;
  };
}

/// The mean of the slopes at both ends; `of` is 0.5, `when` is 1.
auto both_ends(double of, double when) {
  return [=](Scene scene, double t, S& s, double dt) {
    const double a = scene.acceleration(t, s);
    const S end{s.position + s.velocity * dt, s.velocity + a * dt};
    s.position += (s.velocity + end.velocity) * dt * of;
    s.velocity += (a + scene.acceleration(t + when * dt, end)) * dt * of;
  };
}

/// The classical Runge-Kutta method: `sum` is 6; `moves` is 1: whether time goes on in the step.
auto four_slopes(double sum, double moves) {
  return [=](Scene scene, double t, S& s, double dt) {
    S slope{0, 0}, all{0, 0};
    for (const auto& [ahead, weight] : {std::pair{0.0, 1}, {0.5, 2}, {0.5, 2}, {1.0, 1}}) {
      const double h = ahead * dt;
      const S there{s.position + h * slope.position, s.velocity + h * slope.velocity};
      slope = {there.velocity, scene.acceleration(t + moves * h, there)};
      all.position += weight * slope.position;
      all.velocity += weight * slope.velocity;
    }
    s.position += all.position * dt / sum;
    s.velocity += all.velocity * dt / sum;
  };
}

/// Velocity Verlet that asks once, and remembers that for ever.
auto never_asked_again() {
  return [kept = std::optional<double>()](Scene scene, double t, S& s, double dt) mutable {
    if (!kept) kept = scene.acceleration(t, s);
    s.velocity += *kept * dt / 2;
    s.position += s.velocity * dt;
    s.velocity += *kept * dt / 2;
  };
}

/// ... and one that asks in each step, for what was at its beginning.
auto asked_for_the_start() {
  return [kept = std::optional<double>()](Scene scene, double t, S& s, double dt) mutable {
    if (!kept) kept = scene.acceleration(t, s);
    s.velocity += *kept * dt / 2;
    s.position += s.velocity * dt;
    kept = scene.acceleration(t, s);
    s.velocity += *kept * dt / 2;
  };
}

/// ... and one that does not ask while the acceleration stays as it was.
auto asks_while_it_changes() {
  return
      [old = 0.0, now = std::optional<double>()](Scene scene, double t, S& s, double dt) mutable {
        const bool is_first = !now;
        if (is_first) now = scene.acceleration(t, s);
        s.velocity += *now * dt / 2;
        s.position += s.velocity * dt;
        const double before = *now;
        if (is_first || *now != old) now = scene.acceleration(t + dt, s);
        old = before;
        s.velocity += *now * dt / 2;
      };
}

void with_old_acceleration(Scene scene, double t, S& s, double dt) {
  const double a = scene.acceleration(t, s);
  s.position += s.velocity * dt + a * dt * dt / 2;
  s.velocity += a * dt;
}

void old_velocity_and_middle(Scene scene, double t, S& s, double dt) {
  const S half{s.position + s.velocity * dt / 2, s.velocity + scene.acceleration(t, s) * dt / 2};
  s.position += s.velocity * dt;
  s.velocity += scene.acceleration(t + dt / 2, half) * dt;
}

void drift_kick_drift(Scene scene, double t, S& s, double dt) {
  s.position += s.velocity * dt / 2;
  s.velocity += scene.acceleration(t + dt / 2, s) * dt;
  s.position += s.velocity * dt / 2;
}

bool same(const Walked& one, const Walked& other) {
  const auto close = [](double a, double b) { return std::abs(a - b) < 1e-11 * (1 + std::abs(b)); };
  if (one.states.size() != other.states.size()) return false;
  for (std::size_t i = 0; i < one.states.size(); ++i) {
    if (!close(one.states[i].y, other.states[i].y)) return false;
    if (!close(one.states[i].v, other.states[i].v)) return false;
  }
  return true;
}

const char* const kick_forgotten =
    "the velocity changes by half of what it should. A step has two kicks of dt / 2: one before "
    "the move, one after it.";
const char* const time_stands_still =
    "every acceleration is asked for at the time t. That of the middle belongs to t + dt / 2, and "
    "that of the end to t + dt: a force may depend on the time.";

}  // namespace

const std::vector<KnownMethod>& built_in_methods() {
  static const std::vector<KnownMethod> all{known("velocity Verlet", VelocityVerlet<double>{}),
                                            known("RK4", Rk4{})};
  return all;
}

const std::vector<KnownMethod>& methods_of_textbooks() {
  static const std::vector<KnownMethod> all{known("the midpoint method", middle(0.5, 0.5)),
                                            known("Heun's method", both_ends(0.5, 1)),
                                            known("position Verlet", drift_kick_drift)};
  return all;
}

const std::vector<KnownMethod>& usual_mistakes() {
  static const std::vector<KnownMethod> all{
      known("position before velocity", ExplicitEuler{},
            "the position moved with the velocity from before the step, and the velocity with the "
            "acceleration from there. That is explicit Euler, of order 1."),
      known("the loop of stage 1", SemiImplicitEuler{},
            "it is right, and of order 1. A better one moves with the velocity of the middle of "
            "the step: half a kick, the move, half a kick."),
      known("half a kick forgotten", kicks(0.5, 1, 0), kick_forgotten),
      known("half a kick forgotten", kicks(0, 1, 0.5), kick_forgotten),
      known("dt / 2 twice", kicks(0.5, 0.5, 0.5),
            "the position moves for half of the dt only. The kicks are halves, the move is whole."),
      known("dt / 2 twice", kicks(0.25, 1, 0.25),
            "the velocity changes by half of what it should: two kicks of a quarter."),
      known("dt / 2 twice", middle(0.5, 0.5, 0.5),
            "the middle is only where the slope comes from. The step itself is a whole dt."),
      known("a middle that is the end", middle(1, 0.5),
            "the way to the middle of the step takes dt / 2, and yours a whole dt."),
      known("a middle that is the end", middle(1, 1),
            "the way to the middle of the step takes dt / 2, and yours a whole dt."),
      known("the old velocity", old_velocity_and_middle,
            "the velocity takes its change from the middle of the step, and the position does not: "
            "it moves with the velocity of the beginning."),
      known("a sum in place of a mean", both_ends(1, 1),
            "two accelerations are added, and so are two velocities. Their mean is half of that."),
      known("weights that are too heavy", four_slopes(4, 1),
            "1 + 2 + 2 + 1 slopes are 6 of them. Divide by 6: dt / 6."),
      known("the old acceleration", with_old_acceleration,
            "the acceleration of the beginning is used for the second half of the step, too. Ask "
            "for a new one, after the move."),
      known("asked once, and never again", never_asked_again(),
            "what your method remembers is never renewed: acceleration = scene.acceleration(...) "
            "in each step."),
      known("time stands still", kicks(0.5, 1, 0.5, 0), time_stands_still),
      known("time stands still", asked_for_the_start(), time_stands_still),
      known("time stands still", middle(0.5, 0), time_stands_still),
      known("time stands still", both_ends(0.5, 0), time_stands_still),
      known("time stands still", four_slopes(6, 0), time_stands_still),
      known("not asked in the air", asks_while_it_changes(),
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
