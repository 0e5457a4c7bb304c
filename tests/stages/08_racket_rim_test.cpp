// Stage 8's rim: the law of a ball that is pressed out over it, and the method `reference`.

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "08_racket_game/racket_game.hpp"
#include "08_racket_game/run/command_line.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/racket_reference_values.hpp"

using namespace bounce;
using Eigen::Vector3d;
using Ball = State<Vector3d>;

namespace {

/// "name=value name=value" with ball and racket alone.
BareRacketRun run_of(const std::string& settings, Method method, double tolerance,
                     double dt = 1e-3) {
  BareRacketRun run;
  std::istringstream words(settings);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    test::set(run, word.substr(0, equals), word.substr(equals + 1));
  }
  run.use_method(method);
  run.use_tolerance(tolerance);
  run.use_dt(dt);
  run.restart();
  return run;
}

/// The largest distances to the committed values.
StateError largest_error(const test::RacketReferenceCase& it, Method method, double tolerance,
                         double dt = 1e-3) {
  BareRacketRun run = run_of(it.settings, method, tolerance, dt);
  StateError largest{0, 0};
  for (const auto& row : it.rows) {
    run.advance_to(row[0]);
    const Ball ball = run.state();
    const Vector3d position(row[1], row[2], row[3]), velocity(row[4], row[5], row[6]);
    largest.position = std::max(largest.position, (ball.position - position).norm());
    largest.velocity = std::max(largest.velocity, (ball.velocity - velocity).norm());
  }
  return largest;
}

const std::string through_disc =
    "stiffness=1e4 damping=0 position=0.2,0.3,0 velocity=4,-14,1 racket_velocity=0.5,-1,0.2";

}  // namespace

// ---- The law beyond the rim

TEST_CASE("stage 8: beyond the rim the push is the gradient of a distance that fits both sides") {
  for (const int side : {1, -1}) {
    Racket racket;
    racket.disc.normal = Vector3d(0.2, 1, -0.1).normalized();
    racket.side = side;
    const Vector3d along = racket.disc.normal.cross(Vector3d::UnitZ()).normalized();
    const auto found = [&](double x, double y, bool through) {
      racket.through = through;
      return racket.nearest(racket.disc, (0.3 + x) * along + side * y * racket.disc.normal);
    };
    const double shift = 1e-9, depth = 0.04;
    CAPTURE(side);
    // At both borders distance and direction are the neighbours', up to shift / depth.
    const double near = 20 * shift / depth;
    const NearestPoint face = found(-shift, -depth, true), out = found(shift, -depth, true);
    CHECK(std::abs(face.distance - out.distance) < near);
    CHECK((face.direction - out.direction).norm() < near);
    const NearestPoint rim = found(depth, shift, true), below = found(depth, -shift, true);
    CHECK(std::abs(rim.distance - below.distance) < near);
    CHECK((rim.direction - below.direction).norm() < near);
    // Without that memory they are opposite.
    CHECK((face.direction - found(shift, -depth, false).direction).norm() > 1.9);

    // A gradient, by differences: so the spring neither gains nor loses energy.
    for (const double x : {0.002, 0.03, 0.08}) {
      for (const double y : {-0.003, -0.04, -0.1}) {
        const double h = 1e-6;
        const double dx = found(x + h, y, true).distance - found(x - h, y, true).distance;
        const double dy = found(x, y + h, true).distance - found(x, y - h, true).distance;
        const Vector3d gradient = (dx * along + side * dy * racket.disc.normal) / (2 * h);
        // h^2 / 6 times third derivatives of about 20 / length^2, and rounding / h.
        const double tolerance = 4 * h * h / (x * x + y * y) + 1e-9;
        CAPTURE(x);
        CAPTURE(y);
        CHECK((found(x, y, true).direction - gradient).norm() < tolerance);
        CHECK(gradient.dot(side * racket.disc.normal) > 0);  // never back to the other side
        CHECK(gradient.norm() <= 2 + 1e-6);
      }
    }
  }
}

TEST_CASE("stage 8: whoever let off, or came along beside the disc, meets the rim as it is") {
  Racket racket;
  racket.choose_side(0, {0.25, -0.02, 0});  // pressed through
  CHECK(racket.through);
  racket.choose_side(0, {0.33, -0.02, 0});  // out over the rim
  CHECK(racket.through);
  CHECK(racket.side == 1);
  racket.choose_side(0, {0.45, -0.02, 0});  // off
  CHECK_FALSE(racket.through);
  CHECK(racket.side == -1);
  racket.side = 1;
  racket.choose_side(0, {0.33, 0.02, 0});
  racket.choose_side(0, {0.33, -0.02, 0});  // down beside the rim, in contact with it
  CHECK_FALSE(racket.through);
  CHECK(racket.force(0, {{0.33, -0.02, 0}, {0, 0, 0}}).y() < -racket.mass * racket.gravity);
}

TEST_CASE("stage 8: without a damper the energy is kept, through the disc and out over its rim") {
  BareRacketRun run = run_of(through_disc, methods::reference, 1e-12);
  const auto energy = [&] {  // seen from the racket, where nothing gives or takes
    Ball ball = run.state();
    ball.velocity -= Vector3d(0.5, -1, 0.2);
    ball.position -= Vector3d(0.5, -1, 0.2) * run.time();
    return ball.velocity.squaredNorm() / 2 + 9.81 * ball.position.y();
  };
  const double before = energy();
  bool was_through = false;
  for (double t = 1e-3; t < 0.2; t += 1e-3) {
    run.advance_to(t);
    was_through = was_through || run.world().through;
  }
  CHECK(was_through);
  CHECK(energy() == doctest::Approx(before).epsilon(1e-11));
}

// ---- The method `reference`

TEST_CASE("stage 8: reference is right to 1e-11 m on face, rim and beyond (34-digit values)") {
  for (const test::RacketReferenceCase& it : test::racket_reference_cases) {
    const StateError error = largest_error(it, methods::reference, 1e-12);
    CAPTURE(it.name);
    CHECK(error.position < 1e-11);
    CHECK(error.velocity < 1e-11);
  }
}

TEST_CASE("stage 8: the error of reference follows its tolerance") {
  for (const test::RacketReferenceCase& it : test::racket_reference_cases) {
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const StateError error = largest_error(it, methods::reference, tolerance);
      CAPTURE(it.name);
      CAPTURE(tolerance);
      // Of speeds up to 20 m/s, over a contact and a flight of half a second.
      CHECK(error.position < 10 * tolerance);
      CHECK(error.velocity < 20 * tolerance);
      CHECK(error.velocity > 1e-5 * tolerance);  // and does not work harder than asked
    }
  }
}

TEST_CASE("stage 8: stepping methods follow the same law over the rim and beyond") {
  // Another implementation of it: racket_game.hpp, by position. Pieces of omega0 dt = 1e-3, and
  // kinks.
  for (const test::RacketReferenceCase& it : test::racket_reference_cases) {
    CAPTURE(it.name);
    CHECK(largest_error(it, methods::rk4, 1e-12, 1e-3).position < 1e-4);
    CHECK(largest_error(it, methods::velocity_verlet, 1e-12, 1e-2).position < 1e-3);
  }
}

TEST_CASE("stage 8: on the face reference agrees with exact to 1e-11 m") {
  for (const std::string contact : {"may-pull", "push-only"}) {
    for (const std::string damping : {"0", "14.17", "150", "300"}) {
      const std::string settings = "contact=" + contact + " damping=" + damping +
                                   " racket_normal=0.05,1,0.02 racket_radius=50 "
                                   "racket_velocity=0.2,1.5,-0.1";
      BareRacketRun exact = run_of(settings, methods::exact, 1e-12);
      BareRacketRun run = run_of(settings, methods::reference, 1e-12);
      for (double t = 0.1; t < 3; t += 0.1) {
        exact.advance_to(t);
        run.advance_to(t);
        CAPTURE(settings);
        CAPTURE(t);
        REQUIRE((run.state().position - exact.state().position).norm() < 1e-11);
        REQUIRE((run.state().velocity - exact.state().velocity).norm() < 1e-10);
      }
    }
  }
}

TEST_CASE("stage 8: reference does not depend on who looks") {
  BareRacketRun once = run_of(through_disc, methods::reference, 1e-10);
  BareRacketRun often = run_of(through_disc, methods::reference, 1e-10);
  once.advance_to(0.5);
  for (double t = 0; t < 0.5; t += 0.0007) often.advance_to(t);
  often.advance_to(0.5);
  CHECK(often.values() == once.values());
}

TEST_CASE("stage 8: from a touch without speed the ball falls off, and from rest on it, it stays") {
  BareRacketRun hangs = run_of("position=0,-0.1,0", methods::reference, 1e-12);
  hangs.advance_to(1);
  CHECK(hangs.state().position.y() == doctest::Approx(-0.1 - 9.81 / 2).epsilon(1e-12));
  BareRacketRun lies = run_of("position=0,0.1,0 damping=150", methods::reference, 1e-12);
  lies.advance_to(10);
  CHECK(lies.state().position.y() == doctest::Approx(0.1 - 9.81e-4).epsilon(1e-9));
}

TEST_CASE("stage 8: where exact ends at the rim, the others are compared with reference") {
  BareRacketRun run = run_of("position=0.35,1,0", methods::rk4, 1e-12);
  run.advance_to(0.6);
  REQUIRE(run.error());
  CHECK(run.error()->position < 1e-4);
  CHECK(run.error()->position > 1e-12);  // it is another method
}

TEST_CASE("stage 8: reference ends, whatever the numbers") {
  for (const std::string settings :
       {"--set gravity=1e30", "--set mass=1e-30 --set stiffness=1e30", "--set damping=1e30",
        "--set mass=1e30", "--set radius=1e-30", "--set radius=1e30", "--set racket_radius=1e-30",
        "--set position=0.3,1,0 --set damping=0", "--set velocity=0,1e15,0",
        "--set position=0.35,1,0 --set radius=1e-12", "--set racket_velocity=1e15,0,0",
        "--set gravity=0 --set velocity=1e-300,0,0", "--set stiffness=1e-30 --set gravity=1e9"}) {
    const test::Outcome run = test::run_program(
        "08_racket_game --player none --headless --method reference --duration 0.6 " + settings);
    CAPTURE(settings);
    CAPTURE(run.err);
    CHECK((run.code == 0 || run.code == 3));
  }
}

// ---- What `exact` must see of the rim, though it has no formula for it

namespace {

/// When `exact` meets the rim [s]; negative when it does not.
double meets_rim(const std::string& settings, double until) {
  BareRacketRun run = run_of(settings, methods::exact, 1e-12);
  try {
    run.advance_to(until);
  } catch (const NoClosedForm& end) {
    return end.t;
  }
  return -1;
}

}  // namespace

TEST_CASE("stage 8: exact sees a ball that grazes the rim, and one that just misses it") {
  // Without gravity, straight past the disc in its plane: the rim (0.3 m) and the ball (0.1 m)
  // touch where the ball's centre is 0.4 m from the axis. It comes 0.5 m along at 1 m/s, `by`
  // nearer.
  for (const double by : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    for (const double height : {0.0, 0.06}) {  // and 0.08 m from the rim's circle, at that height
      const double reach = 0.3 + std::sqrt(0.1 * 0.1 - height * height);
      for (const double sign : {1.0, -1.0}) {
        const double passes = reach - sign * by;
        const double t = meets_rim("gravity=0 velocity=0,0,1 position=" + to_text(passes) + "," +
                                       to_text(height) + ",-0.5",
                                   1);
        CAPTURE(by);
        CAPTURE(height);
        CAPTURE(sign);
        if (sign < 0) {
          CHECK(t == -1);
          continue;
        }
        const double half = std::sqrt((reach - passes) * (reach + passes));
        // A rounding of the distance (1e-16 m) moves a grazing touch by that over its slope there.
        CHECK(std::abs(t - (0.5 - half)) < 1e-15 + 4e-16 * reach / half);
      }
    }
  }
}

TEST_CASE("stage 8: exact sees a ball that slides over the rim, fast, slowly and tangentially") {
  // Pressed in by 1e-3 m on the disc, without gravity and nearly without a spring, it keeps on
  // sliding: along a chord that lies `by` inside the rim.
  for (const double by : {0.3, 1e-2, 1e-4, 1e-8, 1e-12}) {
    for (const double speed : {1.0, 1e-3, 1e3}) {
      const double x = 0.3 - by, half = std::sqrt(by * (0.6 - by));
      const std::string settings = "gravity=0 stiffness=1e-12 damping=0 position=" + to_text(x) +
                                   ",0.099,0 velocity=0,0," + to_text(speed);
      const double t = meets_rim(settings, 10 / speed);
      CAPTURE(by);
      CAPTURE(speed);
      CHECK(std::abs(t * speed - half) < 4e-16 + 4e-16 * 0.3 / half);
    }
  }
}

TEST_CASE("stage 8: a racket as small as a point, or smaller than a rounding, is no hole") {
  for (const char* radius : {"1e-3", "1e-12", "1e-20", "1e-30"}) {
    CAPTURE(radius);
    const std::string small = std::string("racket_radius=") + radius + " racket_position=1,0,0 ";
    // Straight onto it: face to face. A little beside: the rim, after the same fall of 0.9 m.
    BareRacketRun centred = run_of(small + "position=1,1,0", methods::exact, 1e-12);
    centred.advance_to(1);
    CHECK(centred.state().position.y() > 0.1);
    const double t = meets_rim(small + "position=1.01,1,0", 1);
    const double fall = 1 - std::sqrt(0.1 * 0.1 - 0.01 * 0.01);
    if (std::string(radius) != "1e-3") {
      CHECK(t == doctest::Approx(std::sqrt(2 * fall / 9.81)).epsilon(1e-9));
    } else {
      CHECK(t > 0);
    }
    // From there on the reference knows what happens; and all methods the same.
    BareRacketRun reference = run_of(small + "position=1.01,1,0", methods::reference, 1e-12);
    BareRacketRun stepped = run_of(small + "position=1.01,1,0", methods::rk4, 1e-12);
    reference.advance_to(0.6);
    stepped.advance_to(0.6);
    CHECK(reference.state().velocity.x() > 0.1);
    CHECK((reference.state().position - stepped.state().position).norm() < 1e-3);
  }
}

// ---- The energy book

TEST_CASE("stage 8: what the racket gave and the damper took is told apart; the rest is error") {
  const std::string scenes[] = {
      "damping=0", "damping=30", "damping=30 racket_velocity=0.1,0.4,0.2 racket_normal=0.1,1,0",
      "damping=60 contact=push-only position=0.33,1,0.1 racket_velocity=0.1,0.3,0"};
  for (const std::string& settings : scenes) {
    CAPTURE(settings);
    double coarse = 0;
    for (const double dt : {1e-3, 2.5e-4}) {
      BareRacketRun run = run_of(settings, methods::rk4, 1e-12, dt);
      run.keep_energy_book(true);
      run.restart();
      const double start = run.energy().total();
      run.advance_to(0.9);
      const double error =
          run.energy().total() + run.energy_account().lost - run.energy_account().before;
      CAPTURE(dt);
      CAPTURE(run.energy_account().lost);
      // What went missing is not small, and the book finds all of it. Each contact is cut into 3000
      // pieces of 2e-5 s and less; a touch or let-go within one is counted by a piece too much.
      if (settings != "damping=0") CHECK(run.energy_account().lost > 0.02 * start);
      if (settings.find("racket_velocity") != std::string::npos) {
        CHECK(std::abs(run.energy_account().before - start) > 0.02 * start);
      }
      CHECK(std::abs(error) < 1e-3 * start);
      if (coarse == 0) coarse = error;
    }
    CHECK(coarse != 0);  // a number that says something
    // By events there is no error: the work of the racket and of the damper balance.
    BareRacketRun reference = run_of(settings, methods::reference, 1e-12);
    const double start = reference.energy().total();
    reference.advance_to(0.9);
    CHECK(reference.energy_account().before - reference.energy_account().lost ==
          doctest::Approx(reference.energy().total()).epsilon(1e-12));
    CHECK(reference.energy_account().lost > -1e-9 * start);
  }
}
