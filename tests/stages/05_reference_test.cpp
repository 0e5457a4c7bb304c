// Stage 5's method `reference` against 40-digit values, formulas, and a plain method with tiny
// steps.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "05_ball_collision/reference/ball_contacts.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "05_ball_collision/scenes/scenes.hpp"
#include "ball_reference_values.hpp"
#include "methods.hpp"
#include "physics/events/damped_oscillator.hpp"
#include "physics/events/reference_walk.hpp"
#include "physics/methods/stepping_methods.hpp"
#include "random_numbers.hpp"

using namespace bounce;
using Eigen::Vector3d;

namespace {

using Balls = State<Eigen::Matrix3Xd>;
using Walk = Reference<BallContacts, Eigen::Matrix3Xd>;

/// Balls in empty space; a row for each: mass, radius, x, y, z, vx, vy, vz.
struct Start {
  BallCollision scene;
  Balls balls;

  explicit Start(const std::vector<std::vector<double>>& rows) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    scene.gravity = 0;
    scene.floor = false;
    scene.mass.resize(count);
    scene.radius.resize(count);
    balls.position.resize(3, count);
    balls.velocity.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::vector<double>& row = rows[static_cast<std::size_t>(i)];
      scene.mass[i] = row.at(0);
      scene.radius[i] = row.at(1);
      balls.position.col(i) << row.at(2), row.at(3), row.at(4);
      balls.velocity.col(i) << row.at(5), row.at(6), row.at(7);
    }
  }
  explicit Start(const test::BallReference& of) : Start(of.start) {
    scene.gravity = of.gravity;
    scene.stiffness = scene.floor_stiffness = of.stiffness;
    scene.damping = scene.floor_damping = of.damping;
    scene.contact = of.push_only ? ContactLaw::push_only : ContactLaw::may_pull;
    scene.floor = of.floor;
  }

  Walk walk(double tolerance = 1e-12) const { return {{scene, balls}, 0, balls, tolerance}; }
  Balls at(double t, double tolerance = 1e-12) const {
    Walk walk = this->walk(tolerance);
    REQUIRE(walk.reach(t, 1000000));
    return walk.at(t);
  }
};

/// The largest difference of any coordinate [m], and of any velocity [m/s].
StateError difference(const Balls& a, const Balls& b) {
  return {(a.position - b.position).cwiseAbs().maxCoeff(),
          (a.velocity - b.velocity).cwiseAbs().maxCoeff()};
}

Balls balls_of(const test::BallReference::Answer& answer) {
  Balls balls;
  balls.position.resize(3, static_cast<Eigen::Index>(answer.balls.size()));
  balls.velocity = balls.position;
  for (Eigen::Index i = 0; i < balls.position.cols(); ++i) {
    const std::vector<double>& row = answer.balls[static_cast<std::size_t>(i)];
    balls.position.col(i) << row[0], row[1], row[2];
    balls.velocity.col(i) << row[3], row[4], row[5];
  }
  return balls;
}

StateError error_of(const test::BallReference& of, double tolerance) {
  StateError worst{0, 0};
  for (const auto& answer : of.answers) {
    const StateError error = difference(Start(of).at(answer.t, tolerance), balls_of(answer));
    worst.position = std::max(worst.position, error.position);
    worst.velocity = std::max(worst.velocity, error.velocity);
  }
  return worst;
}

}  // namespace

TEST_CASE("stage 5: reference is right to 1e-10 against 40 digits, whatever touches") {
  for (const test::BallReference& of : test::ball_reference_values()) {
    const StateError error = error_of(of, 1e-12);
    INFO(of.name, ": off by ", error.position, " m and ", error.velocity, " m/s");
    CHECK(error.position < 1e-10);
    CHECK(error.velocity < 1e-10);
  }
}

TEST_CASE("stage 5: the tolerance rules reference's error") {
  for (const test::BallReference& of : test::ball_reference_values()) {
    std::vector<double> tolerances, errors;
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      tolerances.push_back(tolerance);
      errors.push_back(error_of(of, tolerance).position);
      INFO(of.name, ", tolerance ", tolerance, ": off by ", errors.back(), " m");
      CHECK(errors.back() < tolerance);
    }
    const double slope = test::fitted_slope(tolerances, errors);
    INFO(of.name, ": the error falls as tolerance ^ ", slope);
    CHECK(slope > 0.7);
  }
}

TEST_CASE("stage 5: reference follows a head-on contact as the damped oscillator does") {
  // With e = x1 - x2 - (r1 + r2) the pair is one oscillator with the reduced mass. From the touch
  // on its movement, its end and its restitution are formulas (contact.hpp, damped_oscillator.hpp).
  const double m1 = 0.7, m2 = 2, reduced = m1 * m2 / (m1 + m2), speed = 1.5, apart = 0.25;
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    for (const double zeta : {0.0, 0.1, 0.5, 0.9, 0.999999, 1.0, 1.5, 4.0}) {
      Start start({{m1, 0.1, -0.1 - apart, 0, 0, speed, 0, 0}, {m2, 0.2, 0.2, 0, 0, 0, 0, 0}});
      start.scene.contact = law;
      start.scene.damping = 2 * zeta * std::sqrt(1e4 * reduced);
      const double touch = apart / speed, omega = std::sqrt(1e4 / reduced);
      const DampedOscillator overlap(omega, zeta * omega);
      const SpringDamper contact{1e4, start.scene.damping, law};
      CAPTURE(zeta);
      CAPTURE(static_cast<int>(law));
      for (const double share : {0.1, 0.5, 1.0}) {
        const double t = share * std::min(contact_time(contact, reduced), 3 / omega);
        const State<double> right = overlap.move({0, speed}, t);
        const Balls balls = start.at(touch + t);
        const double got = 0.3 - (balls.position(0, 1) - balls.position(0, 0));
        CHECK(std::abs(got - right.position) < 1e-13);
        CHECK(std::abs(balls.velocity(0, 0) - balls.velocity(0, 1) - right.velocity) < 1e-12);
      }
      const double left = start.at(3).velocity(0, 1) - start.at(3).velocity(0, 0);
      CHECK(std::abs(left - restitution(contact, reduced) * speed) < 1e-12);
    }
  }
}

TEST_CASE("stage 5: reference obeys the law of the other methods, in crowds") {
  // A plain loop with RK4 on the scene's own law, without events. Its error at a touch is of second
  // order at best and of first with a damper, hence the size of dt, and what is left of it.
  std::mt19937_64 generator(5);
  const auto random = [&](double low, double high) { return test::uniform(generator, low, high); };
  for (int crowd = 0; crowd < 12; ++crowd) {
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < 8; ++i) {
      rows.push_back({random(0.5, 2), random(0.05, 0.1), random(0, 0.5), random(0, 0.5),
                      random(0, 0.3), random(-1, 1), random(-1, 1), random(-1, 1)});
    }
    Start start(rows);
    start.scene.gravity = 9.81;
    start.scene.floor = true;
    start.scene.tray = {0.5, 0.3};
    start.scene.damping = crowd % 3 * 10;
    start.scene.floor_damping = crowd % 2 * 30;
    start.scene.contact = crowd % 4 < 2 ? ContactLaw::may_pull : ContactLaw::push_only;
    Balls plain = start.balls;
    constexpr double dt = 1e-6;
    for (int i = 0; i < 50000; ++i) rk4(start.scene, 0, plain, dt);
    const StateError off = difference(start.at(0.05), plain);
    CAPTURE(crowd);
    // The damper's force is seen up to a step late: c v / m dt = 1e-4 m/s for 100 m/s^2.
    const bool damped = start.scene.damping + start.scene.floor_damping > 0;
    CHECK(off.velocity < (damped ? 100 : 1) * dt);
    CHECK(off.position < (damped ? 10 : 0.1) * dt);
  }
}

TEST_CASE("stage 5: in a heap reference knows of everyone who overlaps, and of nobody else") {
  // 60 balls fall into a tray. What it has pieced together from events must be what is seen afresh.
  const std::array<double, 2> tray{0.5, 0.5};
  const Arrangement heap = drop(60, 0.0143, tray, 1);
  BallCollision scene;
  scene.tray = tray;
  scene.mass = heap.mass;
  scene.radius = heap.radius;
  for (const double damping : {0.0, 20.0}) {
    scene.damping = scene.floor_damping = damping;
    const auto numbers = [](const BallContacts& contacts) {
      NumberWriter writer;
      BallContacts::remembered(contacts, writer);
      return writer.take();
    };
    Walk walk({scene, heap.balls}, 0, heap.balls, 1e-9);
    std::size_t most = 0;
    for (int i = 1; i <= 500; ++i) {
      const double t = 1e-3 * i;
      REQUIRE(walk.reach(t, 100000));
      const auto held = numbers(walk.contacts());
      CAPTURE(t);
      CHECK(held == numbers(BallContacts(scene, walk.at(t))));
      most = std::max(most, held.size() / 5);
    }
    CHECK(most > 80);  // contacts at a time: it was a heap
  }
}

TEST_CASE(
    "stage 5: in a heap, too, the tolerance rules reference's error, at less than order 8 costs") {
  const std::array<double, 2> tray{0.5, 0.5};
  const Arrangement heap = drop(60, 0.0143, tray, 1);
  BallCollision scene;
  scene.tray = tray;
  scene.mass = heap.mass;
  scene.radius = heap.radius;
  for (const double damping : {0.0, 20.0}) {
    scene.damping = scene.floor_damping = damping;
    const auto at = [&](double t, double tolerance) {
      Walk walk({scene, heap.balls}, 0, heap.balls, tolerance);
      REQUIRE(walk.reach(t, 100000));
      // Steps of order 8 only, none of them repeated, would need 12 each.
      if (tolerance > 1e-10) CHECK(walk.force_evaluations() < 12 * walk.pieces());
      return walk.at(t);
    };
    const Balls right = at(0.4, 1e-13);
    for (const double tolerance : {1e-7, 1e-9, 1e-11}) {
      CAPTURE(damping);
      CAPTURE(tolerance);
      CHECK(difference(at(0.4, tolerance), right).position < tolerance);
    }
  }
}

TEST_CASE("stage 5: a flight ends with the first touch of all pairs, however far apart they are") {
  std::mt19937_64 generator(7);
  const auto random = [&](double low, double high) { return test::uniform(generator, low, high); };
  for (int crowd = 0; crowd < 100; ++crowd) {
    const double width = std::pow(10, crowd % 5 - 1.0);
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < 40; ++i) {
      rows.push_back({1, random(0.001, 0.01), random(0, width), random(0, width), random(0, width),
                      random(-1, 1), random(-1, 1) + 100, random(-1, 1)});
    }
    Start start(rows);
    start.scene.gravity = 9.81;
    start.scene.floor = crowd % 2 == 0;
    BallContacts contacts(start.scene, start.balls);
    if (!contacts.in_flight()) continue;
    double first = never;
    for (int i = 0; i < 40; ++i) {
      if (start.scene.floor) {
        first = std::min(first, time_to_touch(start.scene, {i, -1, 1, 1}, start.balls));
      }
      for (int j = i + 1; j < 40; ++j) {
        first = std::min(first, time_to_touch(start.scene, {i, j}, start.balls));
      }
    }
    CAPTURE(crowd);
    CHECK(contacts.flight_time(0, start.balls) == first);
  }
}

TEST_CASE("stage 5: reference keeps momentum and, undamped, energy to its tolerance") {
  for (const int count : {2, 5, 10, 16, 30}) {
    const Arrangement rack = break_up(count, 0);
    BallCollision scene;
    scene.gravity = 0;
    scene.mass = rack.mass;
    scene.radius = rack.radius;
    Walk walk({scene, rack.balls}, 0, rack.balls, 1e-12);
    REQUIRE(walk.reach(5, 100000));
    const Balls after = walk.at(5);
    CAPTURE(count);
    const double before = scene.energy(rack.balls).total();
    CHECK(std::abs(scene.energy(after).total() - before) < 1e-11 * before);
    CHECK((scene.momentum(after) - scene.momentum(rack.balls)).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("stage 5: balls that lie or move together do not keep reference from going on") {
  // Gaps of 0, within rounding, for ever: 27 balls in a cube on the floor, rows that fly.
  std::vector<std::vector<double>> cube, row;
  for (int n = 0; n < 27; ++n) {
    cube.push_back({1, 0.1, 0.2 * (n % 3), 0.1 + 0.2 * (n / 3 % 3), 0.2 * (n / 9), 0, 0, 0});
  }
  for (int n = 0; n < 6; ++n) row.push_back({1, 0.1, 0.2 * n, 0.5, 0.1 * n, 1, 3, 0});
  for (int n = 0; n < 6; ++n) row.push_back({1, 0.1, 0.2 * n, 1.5, 0, 1, 3, 1e-15 * n});
  for (const double damping : {0.0, 20.0, 400.0}) {
    for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
      for (const auto& rows : {cube, row}) {
        Start start(rows);
        start.scene.gravity = 9.81;
        start.scene.floor = true;
        start.scene.damping = start.scene.floor_damping = damping;
        start.scene.contact = law;
        Walk walk = start.walk();
        CAPTURE(damping);
        CAPTURE(rows.size());
        // Each of the balls may swing at the rate of the stiffest chain, with some events a swing,
        // or, over-damped, be stepped at the rate of its damper.
        CHECK(walk.reach(2, 100000));
        CHECK(walk.at(2).position.allFinite());
      }
    }
  }
}

TEST_CASE("stage 5: stacked balls come to rest where their weight presses the springs") {
  const int count = 4;
  std::vector<std::vector<double>> rows;
  for (int n = 0; n < count; ++n) rows.push_back({1, 0.1, 0, 0.1 + 0.2 * n, 0, 0, 0, 0});
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    Start start(rows);
    start.scene.gravity = 9.81;
    start.scene.floor = true;
    start.scene.damping = start.scene.floor_damping = 40;
    start.scene.contact = law;
    const Balls rest = start.at(60);
    double height = 0.1;
    for (int n = 0; n < count; ++n) {
      height -= (count - n) * 9.81 / 1e4;  // the contact below carries those above it
      CAPTURE(n);
      CHECK(std::abs(rest.position(1, n) - height) < 1e-14);
      CHECK(std::abs(rest.velocity(1, n)) < 1e-12);
      height += 0.2;
    }
  }
}

TEST_CASE("stage 5: two fast balls do not pass each other unseen while others are in contact") {
  // A ball that rests on a soft floor (omega0 = 3 rad/s) lets the error control take steps of about
  // a second, in which two others come, meet, and are far away again.
  const double sag = 9.81 / 10;
  for (const double distance : {40.0, 100.0, 200.0, 300.0, 360.0, 500.0}) {
    const std::vector<double> fast{1, 0.1, -distance, 500, 0.05, 400, 0, 0};
    const std::vector<double> target{1, 0.1, 0, 500, 0, 0, 0, 0},
        resting{1, 0.1, 0, 0.1 - sag, 0, 0, 0, 0};
    Start with({fast, target, resting}), without({fast, target});
    for (Start* start : {&with, &without}) {
      start->scene.gravity = 9.81;
      start->scene.floor = true;
      start->scene.stiffness = 1e9;
      start->scene.floor_stiffness = 10;
    }
    const Balls three = with.at(2), two = without.at(2);
    CAPTURE(distance);
    CHECK(std::abs(two.velocity(2, 1)) > 10);  // they did meet
    const double off = (three.position.leftCols(2) - two.position).cwiseAbs().maxCoeff();
    CHECK(off < 1e-9);  // 800 m away
  }
}

TEST_CASE("stage 5: a ball that starts from rest is not overlooked by a long step") {
  // Two lie on a soft floor; the third falls on one of them, within the first step of 2 s.
  const double sag = 9.81 / 10;
  Start start({{1, 0.1, 0, 0.1 - sag, 0, 0, 0, 0},
               {1, 0.1, 3, 0.1 - sag, 0, 0, 0, 0},
               {1, 0.1, 0, 0.3, 0.02, 0, 0, 0}});
  start.scene.gravity = 9.81;
  start.scene.floor = true;
  start.scene.stiffness = start.scene.floor_stiffness = 10;
  Balls plain = start.balls;
  for (int i = 0; i < 100000; ++i) rk4(start.scene, 0, plain, 1e-5);
  Walk walk({start.scene, start.balls}, 0, start.balls, 1e-12, 2);
  REQUIRE(walk.reach(1, 1000));
  const StateError off = difference(walk.at(1), plain);
  CHECK(plain.velocity(2, 2) > 0.01);  // they did meet, off centre
  CHECK(off.position < 1e-8);          // undamped: RK4's second order at the touch, (omega0 dt)^2
}

TEST_CASE("stage 5: a miss by 1e-9 m is a miss for reference, and a graze of 1e-9 m is none") {
  for (const double offset : {-1e-9, 1e-9}) {
    Start start({{1, 0.1, -0.5, 0, 0.2 + offset, 1, 0, 0}, {1, 0.1, 0, 0, 0, 0, 0, 0}});
    const Balls after = start.at(1);
    const double aside = after.velocity(2, 0);
    CAPTURE(offset);
    if (offset > 0) CHECK(aside == 0);
    // The overlap is a parabola: 1e-9 m at most, for 2 sqrt(2 (r1 + r2) 1e-9 m) / v = 4e-5 s. Its
    // integral is 2/3 of the product, and the stiffness makes 2.667e-10 N s of it.
    if (offset < 0) CHECK(aside == doctest::Approx(2.667e-10).epsilon(1e-3));
  }
}

TEST_CASE("stage 5: who looks at a reference run does not change it") {
  const Start start(test::ball_reference_values().back());
  Walk whole = start.walk(1e-9), looked_at = start.walk(1e-9);
  REQUIRE(whole.reach(0.7, 10000));
  for (int i = 1; i <= 700; ++i) {
    REQUIRE(looked_at.reach(0.7 * i / 700, 10000));
    looked_at.at(0.7 * i / 700);
  }
  CHECK(whole.at(0.7).position == looked_at.at(0.7).position);
  CHECK(whole.at(0.7).velocity == looked_at.at(0.7).velocity);
}

TEST_CASE("stage 5: reference is not offered to more balls than it can look at") {
  BallsRun run;
  for (const Parameter& parameter : run.parameters()) {
    if (parameter.name == "scene") parameter.set("drop");
  }
  for (const Parameter& parameter : run.parameters()) {
    if (parameter.name == "count") parameter.set("2000");
  }
  run.use_method(methods::reference);
  run.restart();
  CHECK_FALSE(run.traits().refusal.empty());
  CHECK_THROWS_AS(run.advance_to(1), NoClosedForm);
}
