#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "03_damping/damping.hpp"
#include "03_damping/exact.hpp"
#include "hard_cases/stability_measured.hpp"
#include "physics/contact.hpp"
#include "physics/stability.hpp"
#include "run/one_ball_run.hpp"
#include "run/step_warning.hpp"
#include "run_program.hpp"
#include "run_with.hpp"

using namespace bounce;
using namespace bounce::hard_cases;

namespace {

constexpr double dampings[] = {0,   0.02, 0.1, 0.2, 0.35, 0.5, 0.6, 0.7, 0.8,
                               0.9, 0.97, 1,   1.1, 1.5,  2.3, 3,   5,   10};

double worst_error(const Method& method, const Wall& wall, double omega0_dt) {
  const ContactLaw law = wall.only_pushes ? ContactLaw::push_only : ContactLaw::may_pull;
  const double e = restitution({1, 2 * wall.zeta, law}, 1);
  const RestitutionRange range = restitution_range(method, wall, omega0_dt, 5 * 192);
  // Below 0: one that is still on its way down at the end.
  return std::max(std::abs(range.highest - e), std::abs(std::abs(range.lowest) - e));
}

/// For every method that steps, law and damping ratio.
template <class Visit>
void for_each_contact(const Visit& visit) {
  for (const Method& method : AnyMethod<SteppingMethods<double>>::offered()) {
    for (const bool only_pushes : {false, true}) {
      for (const double zeta : dampings) visit(method, Wall{zeta, only_pushes});
    }
  }
}

}  // namespace

TEST_CASE("hard case: who is not warned has no bounce that is wrong by 0.1, whatever the contact") {
  int warned = 0, silent = 0;
  for_each_contact([&](const Method& method, const Wall& wall) {
    auto run = test::run_with<OneBallRun<Damping, DampingExact>>(
        {{"stiffness", "1"},
         {"damping", to_text(2 * wall.zeta)},
         {"contact", wall.only_pushes ? "push-only" : "may-pull"}},
        method);
    const double limit = method.largest_stable_step(1, wall.zeta);
    for (const double share : {0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99}) {
      const double dt = share * (limit > 0 ? limit : 1);
      run.use_dt(dt);
      const std::string warning = step_warning(run);
      CAPTURE(name_of(method));
      CAPTURE(wall.only_pushes);
      CAPTURE(wall.zeta);
      CAPTURE(dt);
      CAPTURE(warning);
      const double error = worst_error(method, wall, dt);
      if (warning.empty()) CHECK(error <= 0.1);
      if (!warning.empty() && limit > 0) CHECK(error >= 0.09);  // no false alarm
      ++(warning.empty() ? silent : warned);
    }
  });
  CHECK(warned > 300);
  CHECK(silent > 300);
}

TEST_CASE("hard case: methods that locate touches are warned of in time, too") {
  int silent = 0;
  for (const Method& method : {methods::rk4_events, methods::flight_rk4}) {
    for (const std::string law : {"may-pull", "push-only"}) {
      for (const double zeta : dampings) {
        for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
          auto run =
              test::run_with<OneBallRun<Damping, DampingExact>>({{"gravity", "0"},
                                                                 {"stiffness", "1"},
                                                                 {"damping", to_text(2 * zeta)},
                                                                 {"contact", law},
                                                                 {"velocity", "-1"}},
                                                                method);
          const double dt = share * method.largest_stable_step(1, zeta);
          run.use_dt(dt);
          CAPTURE(name_of(method));
          CAPTURE(law);
          CAPTURE(zeta);
          CAPTURE(dt);
          if (!step_warning(run).empty()) continue;
          ++silent;
          const SpringDamper contact{
              1, 2 * zeta, law == "may-pull" ? ContactLaw::may_pull : ContactLaw::push_only};
          for (int moment = 0; moment < 16; ++moment) {
            test::set(run, "position", to_text(0.1 + dt * (moment + 0.5) / 16));
            run.restart();
            run.advance_to(100);
            const double speed = run.state().position > 0.1 ? run.state().velocity : 0;
            CHECK(std::abs(speed - restitution(contact, 1)) <= 0.1);
          }
        }
      }
    }
  }
  CHECK(silent > 100);
}

TEST_CASE("hard case: the step of --dt auto is right to 0.01, whatever the method and contact") {
  for_each_contact([&](const Method& method, const Wall& wall) {
    const ContactLaw law = wall.only_pushes ? ContactLaw::push_only : ContactLaw::may_pull;
    const double dt = comfortable_step_of(method, {1, wall.zeta, law});
    CAPTURE(name_of(method));
    CAPTURE(wall.only_pushes);
    CAPTURE(wall.zeta);
    CAPTURE(dt);
    CHECK(worst_error(method, wall, dt) <= 0.0105);  // 960 moments see a little more than 192
    CHECK(dt <= comfortable_step(1, wall.zeta));
    CHECK(dt >= 0.05 * comfortable_step(1, wall.zeta));  // explicit Euler, undamped: 0.0056 of 0.1
  });
}

TEST_CASE("hard case: a warning says which restitution a bounce can have, and which it has") {
  const std::string critical =
      "03_damping --headless --duration 0.3 --set damping=200 --set gravity=0 "
      "--set position=0.601 --set velocity=-1 --dt ";
  const test::Outcome run = test::run_program(critical + "0.0082");
  CAPTURE(run.err);
  const double highest =  // omega0 = 100 /s, zeta = 1
      restitution_range(methods::semi_implicit_euler, {1}, 0.82, 192).highest;
  CHECK(run.err.find("restitution " + to_rounded_text(highest, 2) + " in place of 0:") !=
        std::string::npos);
  CHECK(test::run_program(critical + "auto").err.find("warning") == std::string::npos);
}
