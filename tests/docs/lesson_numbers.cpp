// The tables of numbers in the lessons, computed with the library. usage: lesson_numbers TABLE
// The lessons show them after <!-- table: lesson_numbers TABLE --> (lesson_tool.hpp).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "01_free_fall/free_fall.hpp"
#include "02_spring_floor/exact.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "07_tilted_plane/exact.hpp"
#include "docs/tables.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "physics/stability.hpp"

using namespace bounce;

namespace {

// ---- A markdown table, row by row ---------------------------------------------------------------

void row(const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) std::printf("| %s ", cell.c_str());
  std::printf("|\n");
}

void header(const std::vector<std::string>& names) {
  row(names);
  for (std::size_t i = 0; i < names.size(); ++i) std::printf("|---");
  std::printf("|\n");
}

std::string text(const char* format, double value) {
  char buffer[60];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// ---- The four stepping methods ------------------------------------------------------------------

enum Stepper { explicit_, semi_implicit, verlet, runge_kutta };
const char* const stepper_names[] = {"explicit Euler", "semi-implicit Euler", "velocity Verlet",
                                     "RK4"};
constexpr Stepper all_steppers[] = {explicit_, semi_implicit, verlet, runge_kutta};

/// Calls `look(state)` after every step, until it says stop (returns false).
template <class Scene, class Look>
void run(const Scene& scene, Stepper stepper, double dt, const Look& look) {
  State<double> state = scene.start;
  VelocityVerlet<double> velocity_verlet;
  for (long n = 0;; ++n) {
    const double t = static_cast<double>(n) * dt;
    switch (stepper) {
      case explicit_:
        explicit_euler(scene, t, state, dt);
        break;
      case semi_implicit:
        semi_implicit_euler(scene, t, state, dt);
        break;
      case verlet:
        velocity_verlet(scene, t, state, dt);
        break;
      case runge_kutta:
        rk4(scene, t, state, dt);
        break;
    }
    if (!look(state)) return;
  }
}

template <class Scene>
State<double> after_steps(const Scene& scene, Stepper stepper, double dt, long steps) {
  State<double> last{};
  run(scene, stepper, dt, [&](const State<double>& state) {
    last = state;
    return --steps > 0;
  });
  return last;
}

/// The tops of the first bounces [m]: the highest step of every flight after the first touch.
template <class Scene>
std::vector<double> apexes(const Scene& scene, Stepper stepper, double dt, std::size_t count) {
  std::vector<double> tops;
  double highest = 0;
  bool touched = false, above = true;
  run(scene, stepper, dt, [&](const State<double>& state) {
    const bool is_above = state.position >= scene.radius;
    if (!is_above && above && touched) tops.push_back(highest);
    if (!is_above) {
      touched = true;
      highest = 0;
    }
    above = is_above;
    highest = std::max(highest, state.position);
    return tops.size() < count;
  });
  return tops;
}

// ---- Stage 1 ------------------------------------------------------------------------------------

void fall_error() {
  header({"dt [s]", stepper_names[0], stepper_names[1], stepper_names[2], stepper_names[3],
          "g t dt / 2"});
  const FreeFall scene;
  const double exact = fly(scene.start, scene.gravity, 1).position;
  for (const int steps : {10, 20, 100, 1000, 10000}) {
    std::vector<std::string> cells{text("%g", 1.0 / steps)};
    for (const Stepper stepper : all_steppers) {
      const double error = after_steps(scene, stepper, 1.0 / steps, steps).position - exact;
      cells.push_back(std::abs(error) < 1e-9 ? "below 1e-12" : text("%+.7f", error));
      if (std::abs(error) < 1e-9 && std::abs(error) > 1e-12) std::exit(1);  // the cell would lie
    }
    cells.push_back(text("%.7f", scene.gravity / (2.0 * steps)));
    row(cells);
  }
}

// ---- Stage 2 ------------------------------------------------------------------------------------

/// How long after the touch the ball turns around [s].
template <class Phases>
double time_to_bottom(const EventDriven<Phases>& at_touch) {
  double down = at_touch.last_event(), up = at_touch.next_event();
  for (int i = 0; i < 80; ++i) {
    const double middle = (down + up) / 2;
    (EventDriven<Phases>(at_touch).at(middle).velocity < 0 ? down : up) = middle;
  }
  return down;
}

void stiffness() {
  header({"stiffness [N/m]", "contact [ms]", "greatest overlap [mm]",
          "peak spring force [times the weight]", "height after the bounce [m]"});
  for (const double k : {2e3, 1e4, 1e5}) {
    SpringFloor scene;
    scene.stiffness = k;
    EventDriven<SpringFloorExact> ball(SpringFloorExact(scene), 0, scene.start);
    ball.pass_event();  // the touch
    const double touch = ball.last_event(), lift_off = ball.next_event();
    EventDriven<SpringFloorExact> probe = ball;
    const double overlap = scene.radius - probe.at(time_to_bottom(ball)).position;
    ball.pass_event();
    const State<double> up = ball.state_at_last_event();
    const double height = up.position + up.velocity * up.velocity / (2 * scene.gravity);
    row({text("%g", k), text("%.1f", (lift_off - touch) * 1e3), text("%.1f", overlap * 1e3),
         text("%.1f", k * overlap / (scene.mass * scene.gravity)), text("%.4f", height)});
  }
}

void height_band() {
  header({"method", "dt [s]", "lowest top [m]", "highest top [m]", "mean of the first 100 [m]",
          "mean of the last 100 [m]"});
  for (const Stepper stepper : {semi_implicit, verlet}) {
    for (const double dt : {1e-3, 5e-4, 1e-4}) {
      const std::vector<double> tops = apexes(SpringFloor{}, stepper, dt, 3000);
      const auto mean = [](auto from, auto to) {
        double sum = 0;
        for (auto top = from; top != to; ++top) sum += *top;
        return sum / static_cast<double>(to - from);
      };
      row({stepper_names[stepper], text("%g", dt),
           text("%.4f", *std::min_element(tops.begin(), tops.end())),
           text("%.4f", *std::max_element(tops.begin(), tops.end())),
           text("%.4f", mean(tops.begin(), tops.begin() + 100)),
           text("%.4f", mean(tops.end() - 100, tops.end()))});
    }
  }
}

void first_apexes() {
  header({"method, dt [s]", "1st top [m]", "2nd", "3rd", "4th", "5th", "6th"});
  const auto add = [](Stepper stepper, double dt) {
    std::vector<std::string> cells{stepper_names[stepper] + text(", %.3g", dt)};
    for (const double top : apexes(SpringFloor{}, stepper, dt, 6)) {
      cells.push_back(text("%.3f", top));
    }
    row(cells);
  };
  add(explicit_, 1e-3);
  add(explicit_, 1e-4);
  add(semi_implicit, 1e-3);
  add(semi_implicit, 1.0 / 60);
}

/// Speed after / speed before one contact without gravity, for many moments at which the first step
/// in the floor may come.
void restitution_range() {
  header({"omega0 dt", "dt at k = 1e4 [ms]", "lowest restitution", "highest restitution"});
  constexpr int moments = 2000;
  for (const double omega0_dt : {0.01, 0.1, 0.2, 0.5, 1.0, 1.5, 1.9}) {
    SpringFloor scene;
    scene.gravity = 0;
    const double dt = omega0_dt / natural_frequency(scene.stiffness, scene.mass);
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (int i = 0; i < moments; ++i) {
      scene.start = {scene.radius + dt * (i + 0.5) / moments, -1};
      double e = 0;
      run(scene, semi_implicit, dt, [&](const State<double>& state) {
        e = state.velocity;
        return !(state.velocity > 0 && state.position >= scene.radius);
      });
      lowest = std::min(lowest, e);
      highest = std::max(highest, e);
    }
    row({text("%g", omega0_dt), text("%g", dt * 1e3), text("%.5f", lowest), text("%.5f", highest)});
  }
}

/// Position error after 1 s (one bounce), the root mean square over 200 runs whose start (within
/// 1 %) and time step (within 10 %) are drawn by lot: whether the moments of touch and lift-off
/// fall on a step decides how lucky one run is. Last row: the slope of log(error) against log(dt).
template <class Scene, class Exact>
void bounce_error(Scene scene) {
  header({"dt [s], about", stepper_names[0], stepper_names[1], stepper_names[2], stepper_names[3]});
  constexpr int runs = 200;
  const std::vector<long> counts{1000, 2000, 4000, 8000, 16000, 32000};
  std::vector<double> sum_xy(4), sum_y(4);
  double sum_x = 0, sum_xx = 0;
  for (const long count : counts) {
    const double x = std::log(1.0 / static_cast<double>(count));
    sum_x += x;
    sum_xx += x * x;
    std::vector<std::string> cells{text("%.4g", 1.0 / static_cast<double>(count))};
    for (const Stepper stepper : all_steppers) {
      std::mt19937 lot;  // the same runs for all
      const auto between = [&lot](double from, double to) {
        return from + (to - from) * static_cast<double>(lot()) / 4294967296.0;
      };
      double square = 0;
      for (int i = 0; i < runs; ++i) {
        scene.start = {between(0.99, 1.01), 0};
        const long steps = std::lround(static_cast<double>(count) * between(0.9, 1.1));
        const double dt = 1.0 / static_cast<double>(steps);
        const double exact = EventDriven<Exact>(Exact(scene), 0, scene.start).at(1).position;
        square += std::pow(after_steps(scene, stepper, dt, steps).position - exact, 2);
      }
      const double error = std::sqrt(square / runs);
      sum_y[stepper] += std::log(error);
      sum_xy[stepper] += x * std::log(error);
      cells.push_back(text("%.1e", error));
    }
    row(cells);
  }
  std::vector<std::string> cells{"order, fitted"};
  const double n = static_cast<double>(counts.size());
  for (const Stepper stepper : all_steppers) {
    const double order =
        (n * sum_xy[stepper] - sum_x * sum_y[stepper]) / (n * sum_xx - sum_x * sum_x);
    cells.push_back(text("%.1f", order));
  }
  row(cells);
}

// ---- Stage 3 ------------------------------------------------------------------------------------

Damping damped(double c, ContactLaw law = ContactLaw::may_pull) {
  Damping scene;
  scene.damping = c;
  scene.contact = law;
  return scene;
}

EventDriven<DampingExact> walk(const Damping& scene) {
  return {DampingExact(scene), 0, scene.start};
}

/// The state at the first lift-off; false when the ball never leaves the floor.
bool lift_off(const Damping& scene, State<double>& state) {
  EventDriven<DampingExact> ball = walk(scene);
  ball.pass_event();
  do {
    if (ball.next_event() == never) return false;
    ball.pass_event();
  } while (ball.phase() != Phase::flight);
  state = ball.state_at_last_event();
  return true;
}

void restitution_table() {
  header({"damping ratio", "damping [N s/m]", "`may-pull`: formula", "`may-pull`: measured",
          "`push-only`: formula", "`push-only`: measured"});
  for (const double zeta : {0.0, 0.05, 0.1, 0.2, 0.5, 0.9, 1.0, 2.0}) {
    const double c = 200 * zeta;  // 2 sqrt(k m) = 200 N s/m
    std::vector<std::string> cells{text("%g", zeta), text("%g", c)};
    for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
      Damping scene = damped(c, law);
      scene.gravity = 0;
      scene.start = {1, -4};
      cells.push_back(text("%.6f", restitution({scene.stiffness, scene.damping, law}, scene.mass)));
      State<double> up{};
      cells.push_back(lift_off(scene, up) ? text("%.6f", up.velocity / 4) : "stays");
    }
    row(cells);
  }
}

void first_apex() {
  header({"damping [N s/m]", "damping ratio", "first top, `may-pull` [m]",
          "pull at lift-off, `may-pull` [N]", "first top, `push-only` [m]"});
  for (const double c : {5.0, 18.0, 25.0, 43.0, 100.0, 140.0, 200.0}) {
    std::vector<std::string> cells{text("%g", c), text("%g", c / 200)};
    for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
      const Damping scene = damped(c, law);
      State<double> up{};
      const bool leaves = lift_off(scene, up);
      const double top = up.position + up.velocity * up.velocity / (2 * scene.gravity);
      cells.push_back(leaves ? text("%.3f", top) : "stays down");
      if (law == ContactLaw::may_pull) cells.push_back(leaves ? text("%.1f", c * up.velocity) : "");
    }
    row(cells);
  }
}

/// The damping at which the ball comes back to half its height, and from which on it stays down.
void turning_points() {
  header({"the ball", "damping [N s/m]"});
  const auto smallest = [](const auto& holds) {
    double below = 5, above = 200;
    for (int i = 0; i < 60; ++i) {
      const double middle = (below + above) / 2;
      (holds(middle) ? above : below) = middle;
    }
    return text("%.1f", above);
  };
  row({"comes back to half its height", smallest([](double c) {
         const Damping scene = damped(c);
         State<double> up{};
         return !lift_off(scene, up) ||
                up.position + up.velocity * up.velocity / (2 * scene.gravity) < 0.5;
       })});
  row({"stays down", smallest([](double c) {
         State<double> up{};
         return !lift_off(damped(c), up);
       })});
}

/// Restitution of one touch after the other, with gravity: it depends on the speed.
void bounces() {
  header({"touch", "speed in, `may-pull` [m/s]", "restitution", "speed in, `push-only` [m/s]",
          "restitution"});
  std::vector<std::vector<std::string>> rows;
  for (std::size_t n = 0; n < 12; ++n) rows.push_back({std::to_string(n + 1), "", "", "", ""});
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    const std::size_t column = law == ContactLaw::may_pull ? 1 : 3;
    EventDriven<DampingExact> ball = walk(damped(18, law));
    for (auto& cells : rows) {
      ball.pass_event();
      const double in = -ball.state_at_last_event().velocity;
      cells[column] = text("%.3f", in);
      while (ball.phase() != Phase::flight && ball.next_event() != never) ball.pass_event();
      const bool leaves = ball.phase() == Phase::flight;
      const double e = ball.state_at_last_event().velocity / in;
      cells[column + 1] = leaves ? text("%.4f", e) : "stays";
      if (!leaves) break;
    }
  }
  for (const auto& cells : rows) row(cells);
  const double may_pull = restitution({1e4, 18, ContactLaw::may_pull}, 1);
  const double push_only = restitution({1e4, 18, ContactLaw::push_only}, 1);
  row({"without gravity", "any", text("%.4f", may_pull), "any", text("%.4f", push_only)});
}

/// The resting height is right at every step; the first bounce is not.
void rest() {
  header({"dt [s]", "first top [m]", "error of the first top [mm]", "height at 30 s [m]",
          "error of that height"});
  const Damping scene = damped(43);
  State<double> up{};
  lift_off(scene, up);
  const double top = up.position + up.velocity * up.velocity / (2 * scene.gravity);
  const double rest_height = scene.radius - scene.mass * scene.gravity / scene.stiffness;
  for (const double dt : {1e-4, 1e-3, 5e-3, 1e-2, 1.5e-2}) {
    const double first = apexes(scene, semi_implicit, dt, 1)[0];
    const double end = after_steps(scene, semi_implicit, dt, std::lround(30 / dt)).position;
    if (std::abs(end - rest_height) > 1e-15) std::exit(1);  // the last column would lie
    row({text("%g", dt), text("%.4f", first), text("%+.1f", (first - top) * 1e3), text("%.6f", end),
         "below 1e-15"});
  }
}

void stable_steps() {
  header({"damping ratio", "damping [N s/m]", "semi-implicit Euler: omega0 dt below", "dt [ms]",
          "explicit Euler: omega0 dt below", "dt [ms]"});
  for (const double zeta : {0.0, 0.025, 0.1, 0.5, 1.0, 2.31}) {
    const double omega0 = 100;  // rad/s: k = 1e4 N/m, m = 1 kg
    const double semi = semi_implicit_euler_limit(zeta), euler = explicit_euler_limit(zeta);
    row({text("%g", zeta), text("%g", 200 * zeta), text("%.3f", semi),
         text("%.2f", semi / omega0 * 1e3), euler > 0 ? text("%.3f", euler) : "never stable",
         euler > 0 ? text("%.2f", euler / omega0 * 1e3) : ""});
  }
}

// ---- Stage 4 ------------------------------------------------------------------------------------

/// A mistake: the damper brakes the whole velocity, not only its part along the floor's normal.
struct VectorDamper : ThreeDimensions {
  Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
    const bool touches = state.position.y() < radius;
    const Eigen::Vector3d sideways(state.velocity.x(), 0, state.velocity.z());
    return (force(t, state) - (touches ? damping : 0) * sideways) / mass;
  }
};

void vector_damper() {
  header({"after touch", "velocity along x, right [m/s]", "velocity along x, wrong [m/s]"});
  const ThreeDimensions right;
  const VectorDamper wrong;
  State<Eigen::Vector3d> a = right.start, b = wrong.start;
  bool was_touching = false;
  for (long n = 0, touches = 0; touches < 4; ++n) {
    const double dt = 1e-4, t = static_cast<double>(n) * dt;
    semi_implicit_euler(right, t, a, dt);
    semi_implicit_euler(wrong, t, b, dt);
    const bool is_touching = b.position.y() < wrong.radius;
    if (was_touching && !is_touching) {
      row({std::to_string(++touches), text("%.3f", a.velocity.x()), text("%.3f", b.velocity.x())});
    }
    was_touching = is_touching;
  }
}

// ---- Stage 7 ------------------------------------------------------------------------------------

/// Hops down a slope: their length along it, and the time from touch to touch.
void slope_hops() {
  header({"tilt", "stiffness [N/m]", "hop 1 [m]", "hop 2 [m]", "hop 3 [m]", "hop 4 [m]",
          "from touch to touch [s]"});
  for (const double degrees : {10.0, 20.0}) {
    for (const double stiffness : {1e6, 1e5, 1e4}) {
      const double angle = degrees * std::numbers::pi / 180;
      TiltedPlane scene;
      scene.damping = 0;
      scene.stiffness = stiffness;
      scene.normal = {std::tan(angle), 1, 0};
      scene.start.position.y() = 0.5 + scene.radius / std::cos(angle);  // falls by 0.5 m
      EventDriven<TiltedPlaneExact, Eigen::Vector3d> ball(TiltedPlaneExact(scene), 0, scene.start);
      std::vector<std::string> cells{text("%g degrees", degrees), text("%g", stiffness)};
      double last_time = 0;
      Eigen::Vector3d last_place;
      for (int touches = 0; touches < 5; ++touches) {
        ball.pass_event();  // the touch
        const Eigen::Vector3d place = ball.state_at_last_event().position;
        if (touches > 0) cells.push_back(text("%.2f", (place - last_place).norm()));
        if (touches == 4) cells.push_back(text("%.4f", ball.last_event() - last_time));
        last_time = ball.last_event();
        last_place = place;
        ball.pass_event();  // the lift-off
      }
      row(cells);
    }
  }
}

/// A mistake: the normal (1, 1, 0), of length 1.41, is used as it is.
struct LongNormal : TiltedPlane {
  Eigen::Vector3d used{1, 1, 0};
  Eigen::Vector3d acceleration(double /*t*/, const State<Eigen::Vector3d>& state) const {
    const double y = dot(used, state.position);
    if (!(y < radius)) return Eigen::Vector3d::Zero();
    return stiffness * (radius - y) * used / mass;
  }
};

void long_normal() {
  header({"normal used", "distance from the plane when the force begins [m]", "contact [ms]"});
  for (const bool unit : {true, false}) {
    LongNormal scene;
    const Eigen::Vector3d n = scene.used.normalized();
    if (unit) scene.used = n;
    State<Eigen::Vector3d> state{0.5 * n, -1.0 * n};
    const double dt = 1e-6;
    const auto touches = [&] { return dot(scene.used, state.position) < scene.radius; };
    const auto step = [&] { semi_implicit_euler(scene, 0, state, dt); };
    while (!touches()) step();
    const double distance = dot(n, state.position);
    long steps = 0;
    for (; touches(); ++steps) step();
    row({unit ? "(1, 1, 0) / 1.41" : "(1, 1, 0)", text("%.4f", distance),
         text("%.1f", static_cast<double>(steps) * dt * 1e3)});
  }
}

const bounce::test::Table tables[] = {
    {"fall_error", fall_error},
    {"stiffness", stiffness},
    {"height_band", height_band},
    {"first_apexes", first_apexes},
    {"restitution_range", restitution_range},
    {"spring_error", [] { bounce_error<SpringFloor, SpringFloorExact>({}); }},
    {"restitution", restitution_table},
    {"first_apex", first_apex},
    {"turning_points", turning_points},
    {"bounces", bounces},
    {"rest", rest},
    {"stable_steps", stable_steps},
    {"vector_damper", vector_damper},
    {"slope_hops", slope_hops},
    {"long_normal", long_normal},
    {"damped_error", [] { bounce_error<Damping, DampingExact>(damped(18)); }},
};

}  // namespace

int main(int argc, char** argv) { return bounce::test::print_table(tables, argc, argv); }
