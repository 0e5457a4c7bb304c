#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "04_three_dimensions/three_dimensions.hpp"
#include "rounding.hpp"
#include "run/save_load.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::epsilon;
using test::run_with;
using test::set;

namespace {

using Run3 = OneBallRun<Damping, DampingExact>;
using Run4 = OneBallRun<ThreeDimensions, ThreeDimensionsExact>;

constexpr double duration = 3;  // s: four bounces from a height of 1 m
constexpr double steps_sizes[] = {1e-2, 1e-3, 1e-4};
const std::vector<Method> stepping{methods::explicit_euler, methods::semi_implicit_euler,
                                   methods::velocity_verlet, methods::rk4};

/// A run that stands at `start`.
Run4 run_from(const State<Vector3d>& start, Method method, double dt, ContactLaw law) {
  const char* contact = law == ContactLaw::may_pull ? "may-pull" : "push-only";
  Run4 run = run_with<Run4>({{"contact", contact}}, method, dt);
  run.place({start.position.x(), start.position.y(), start.position.z(), start.velocity.x(),
             start.velocity.y(), start.velocity.z()});
  return run;
}

}  // namespace

TEST_CASE("stage 4: without sideways velocity it is stage 3, to the bit") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    std::vector<Method> methods = stepping;
    methods.push_back(methods::exact);
    for (const Method method : methods) {
      for (const double dt : steps_sizes) {
        Run3 line;
        set(line, "contact", law == ContactLaw::may_pull ? "may-pull" : "push-only");
        line.use_method(method);
        line.use_dt(dt);
        line.restart();
        Run4 space = run_from({{0, 1, 0}, {0, 0, 0}}, method, dt, law);
        for (double t = 0.1; t <= duration; t += 0.1) {
          line.advance_to(t);
          space.advance_to(t);
          const std::string name = name_of(method);
          CAPTURE(name);
          CAPTURE(dt);
          CAPTURE(t);
          REQUIRE(space.state().position.y() == line.state().position);
          REQUIRE(space.state().velocity.y() == line.state().velocity);
          REQUIRE(space.state().position.x() == 0);
          REQUIRE(space.state().position.z() == 0);
        }
      }
    }
  }
}

TEST_CASE("stage 4: the frictionless floor leaves the sideways velocity alone, to the bit") {
  // No force has a part along x or z, so nothing but zero may ever be added there. A damper that
  // acts on the whole velocity vector fails here.
  const double vx = 1.2345678, vz = -0.3217;
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const Method method : stepping) {
      for (const double dt : steps_sizes) {
        Run4 run = run_from({{0, 1, 0}, {vx, 0, vz}}, method, dt, law);
        // The sideways motion must not change the bounce either.
        Run4 upright = run_from({{0, 1, 0}, {0, 0, 0}}, method, dt, law);
        for (double t = 0.1; t <= duration; t += 0.1) {
          run.advance_to(t);
          upright.advance_to(t);
          const std::string name = name_of(method);
          CAPTURE(name);
          CAPTURE(dt);
          CAPTURE(t);
          REQUIRE(run.state().velocity.x() == vx);
          REQUIRE(run.state().velocity.z() == vz);
          REQUIRE(run.state().position.y() == upright.state().position.y());
        }
      }
    }
  }
}

TEST_CASE("stage 4: whoever looks from a turned frame sees the turned movement") {
  for (const double degrees : {30.0, 90.0, 217.0}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vector3d::UnitY()).toRotationMatrix();
    const State<Vector3d> start{{0.3, 1, -0.2}, {1, 0.4, 0.5}};
    const State<Vector3d> turned{turn * start.position, turn * start.velocity};
    for (const Method method : stepping) {
      for (const double dt : steps_sizes) {
        Run4 run = run_from(start, method, dt, ContactLaw::may_pull);
        Run4 other = run_from(turned, method, dt, ContactLaw::may_pull);
        run.advance_to(duration);
        other.advance_to(duration);
        // Each of the n steps adds to a position and rounds by half an epsilon of it. The position
        // stays below L = 4 m. The turning itself rounds a few times more.
        const double n = duration / dt;
        const double tolerance = (n + 10) * epsilon * 4;
        const double miss = (other.state().position - turn * run.state().position).norm();
        const std::string name = name_of(method);
        CAPTURE(name);
        CAPTURE(dt);
        CAPTURE(degrees);
        CHECK(miss <= tolerance);
        // Up and down nothing was turned.
        CHECK(other.state().position.y() == run.state().position.y());
      }
    }
  }
}

TEST_CASE("stage 4: flight is a parabola") {
  // x = x0 + vx t, z = z0 + vz t, y = y0 + vy t - g t^2 / 2. The methods follow it with the errors
  // of stage 1: +g t dt / 2 for explicit Euler, -g t dt / 2 for semi-implicit Euler, none for
  // velocity Verlet and RK4.
  const Vector3d p0{0.5, 2, -1}, v0{1.5, 3, -0.7};
  const double gravity = 9.81;
  for (const Method method : stepping) {
    for (const double dt : steps_sizes) {
      Run4 run;
      set(run, "floor", "off");
      run.use_method(method);
      run.use_dt(dt);
      run.restart();
      run.place({p0.x(), p0.y(), p0.z(), v0.x(), v0.y(), v0.z()});
      for (const double t : {0.5, 1.0, 2.0}) {  // whole multiples of every dt
        run.advance_to(t);
        const double error_of_method = method == methods::explicit_euler ? gravity * t * dt / 2
                                       : method == methods::semi_implicit_euler
                                           ? -gravity * t * dt / 2
                                           : 0;
        const Vector3d expected =
            p0 + v0 * t + Vector3d(0, -gravity * t * t / 2 + error_of_method, 0);
        // n sums, each rounded by half an epsilon of a height below 20 m; the velocity, below
        // 20 m/s, is such a sum itself and is used n times: its error grows like n^2 dt.
        const double n = t / dt;
        const double tolerance = (n * epsilon * 20) * (1 + t);
        const double miss = (run.state().position - expected).norm();
        const std::string name = name_of(method);
        CAPTURE(name);
        CAPTURE(dt);
        CAPTURE(t);
        CHECK(miss <= tolerance);
      }
    }
  }
}

TEST_CASE("stage 4: exact is stage 3's exact upwards, and uniform motion sideways") {
  for (const char* contact : {"may-pull", "push-only"}) {
    Run3 line;
    Run4 space;
    set(line, "contact", contact);
    set(space, "contact", contact);
    set(space, "velocity", "1,0,0.5");
    for (Simulation* run : {static_cast<Simulation*>(&line), static_cast<Simulation*>(&space)}) {
      run->use_method(methods::exact);
      run->restart();
    }
    for (double t = 0.05; t < 10; t += 0.05) {
      line.advance_to(t);
      space.advance_to(t);
      CAPTURE(contact);
      CAPTURE(t);
      REQUIRE(space.state().position.y() == line.state().position);
      REQUIRE(space.state().velocity.y() == line.state().velocity);
      // One sum an event, and fewer than 200 events in this time.
      REQUIRE(std::abs(space.state().position.x() - 1.0 * t) <= 200 * epsilon * 10);
      REQUIRE(std::abs(space.state().position.z() - 0.5 * t) <= 200 * epsilon * 10);
      REQUIRE(space.state().velocity.x() == 1);
      REQUIRE(space.state().velocity.z() == 0.5);
    }
  }
}

TEST_CASE("stage 4: what the energy column calls lost is the damper's work") {
  // Energy now + lost - energy before is the method's error. In a damped contact the force jumps at
  // the touch, so that the error of RK4 and of the midpoint rule is of order one. At a touch with
  // v = 4.2 m/s one step may book c v^2 dt too much or too little: 0.09 J at dt = 1e-3, four times.
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    Run4 run;
    run.use_method(methods::rk4);
    run.use_dt(dt);
    run.restart();
    run.keep_energy_book(true);
    run.parameters_changed();
    run.advance_to(duration);
    const double error =
        run.energy().total() + run.energy_account().lost - run.energy_account().before;
    CAPTURE(dt);
    CAPTURE(error);
    CHECK(run.energy_account().lost > 3);  // of 10.4 J
    CHECK(std::abs(error) <= 4 * 5.0 * 4.2 * 4.2 * dt);
  }
}

TEST_CASE("stage 4: a saved run goes on as if it had not stopped") {
  const std::string path =
      (std::filesystem::temp_directory_path() / "bounce_stage_4_saved").string();
  const StageName stage{"04_three_dimensions", ""};
  for (const Method method :
       {methods::semi_implicit_euler, methods::velocity_verlet, methods::rk4, methods::exact}) {
    Run4 whole;
    set(whole, "position", "0.1,0.9,-0.3");
    whole.use_method(method);
    whole.restart();
    whole.advance_to(0.4271);  // in the middle of a contact, and of a step
    save_state(path, stage, whole);
    whole.advance_to(duration);

    Run4 resumed = test::loaded<Run4>(path, stage);
    resumed.advance_to(duration);
    const std::string name = name_of(method);
    CAPTURE(name);
    CHECK(resumed.state().position == whole.state().position);
    CHECK(resumed.state().velocity == whole.state().velocity);
  }
  std::filesystem::remove(path);
}

TEST_CASE("stage 4: vector parameters on the command line") {
  const test::Outcome good = test::run_program(
      "04_three_dimensions --headless --csv - --at 0 --set position=-0.5,1e0,+2 --set "
      "velocity=1,-2,0.5");
  CHECK(good.code == 0);
  CHECK(good.out == "t,x,y,z,vx,vy,vz\n0,-0.5,1,2,1,-2,0.5\n");

  for (const char* bad : {"position=0,1", "position=0,1,2,3", "position=0,one,0",
                          "position=0,nan,0", "position=0,inf,0", "position=", "position=0,,0",
                          "position=1", "velocity=0,1e16,0", "floor=maybe"}) {
    const test::Outcome outcome =
        test::run_program(std::string("04_three_dimensions --headless --set ") + bad);
    CAPTURE(bad);
    CAPTURE(outcome.err);
    const std::string setting = bad;
    const std::size_t equals = setting.find('=');
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    // One sentence: the name, the value, and what is allowed.
    CHECK(outcome.err.find(setting.substr(0, equals) + " = '" + setting.substr(equals + 1) + "'") !=
          std::string::npos);
    CHECK(outcome.err.find("it must be " + std::string(setting.rfind("floor", 0) == 0
                                                           ? "on or off"
                                                           : "3 numbers from -1e+15 to 1e+15")) !=
          std::string::npos);
  }

  const test::Outcome list = test::run_program("04_three_dimensions --list");
  for (const char* word : {"position", "0,1,0", "velocity", "1,0,0.5", "on or off"}) {
    CAPTURE(word);
    CHECK(list.out.find(word) != std::string::npos);
  }
}
