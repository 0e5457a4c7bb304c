// An arrow that is drawn is the force that moves the ball. What moves it is told by the step that
// follows: the loop changes the velocity by a dt, so the force at the shown state is m dv / dt.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "05_ball_collision/picture/balls_marks.hpp"
#include "05_ball_collision/picture/balls_picture.hpp"
#include "app/layout.hpp"
#include "app/recording_canvas.hpp"
#include "app/side_view.hpp"
#include "app/space_view.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::Arrow;
using test::RecordingCanvas;
using test::run_with;
using test::same;

namespace {

constexpr double small_step = 1e-3;  // s
constexpr int steps_a_run = 1500;
constexpr float pixel_error = 0.01f;  // places in the window are floats: 6e-5 px each

/// All of a contact is looked at, and every 20th step of a flight.
bool passes_over(Playback& playback, int step) {
  if (playback.simulation().energy().spring > 0 || step % 20 == 0) return false;
  playback.step_forward();
  return true;
}

RecordingCanvas picture_of(const Demo& demo, const Playback& playback) {
  View view;
  view.forces = true;
  RecordingCanvas canvas;
  demo.picture(playback, view, canvas);
  return canvas;
}

/// One step of a run. Returns the force that moved the ball [N].
template <class Vector>
Vector force_of_step(Playback& playback, double mass) {
  const Vector before = state_in<Vector>(playback.shown_values()).velocity;
  playback.step_forward();
  return mass * (state_in<Vector>(playback.shown_values()).velocity - before) / small_step;
}

/// Up and down in pixels, as the picture says: 24 px for the weight, growing with the square root.
double pixels(double force, double weight) {
  return std::copysign(24 * std::sqrt(std::abs(force) / weight), force);
}
double newtons(double up, double weight) { return std::copysign(weight * up * up / 576, up); }

struct Seen {
  int flight = 0, contact = 0;  // steps
};

/// On a line, the arrows add up to the force.
template <class Scene, class Phases>
Seen check_arrows_on_a_line(const test::Values& settings) {
  using Run = OneBallRun<Scene, Phases>;
  const Demo demo = side_demo<Scene, Phases>();
  auto run =
      std::make_unique<Run>(run_with<Run>(settings, methods::semi_implicit_euler, small_step));
  const double mass = run->scene().mass, weight = mass * run->scene().gravity;
  Playback playback(std::move(run));
  Seen seen;
  for (int step = 0; step < steps_a_run; ++step) {
    if (passes_over(playback, step)) continue;
    const RecordingCanvas canvas = picture_of(demo, playback);
    const double force = force_of_step<double>(playback, mass);
    double drawn = 0, error = 0;
    int arrows = 0;
    for (const Colour colour : {palette::gravity, palette::spring, palette::damper}) {
      for (const Colour dot : canvas.dots) {  // an arrow of less than 6 px
        if (same(dot, colour)) error += newtons(6, weight);
      }
      error += newtons(1, weight);  // one of less than 1 px is not drawn
      for (const Arrow& arrow : canvas.arrows) {
        if (!same(arrow.colour, colour)) continue;
        CHECK(std::abs(arrow.x()) < pixel_error);
        drawn += newtons(arrow.up(), weight);
        error += newtons(std::abs(arrow.up()) + pixel_error, weight) -
                 newtons(std::abs(arrow.up()), weight);
        ++arrows;
      }
    }
    CAPTURE(step);
    REQUIRE(std::abs(drawn - force) <= error);
    ++(arrows > 1 ? seen.contact : seen.flight);
  }
  return seen;
}

/// In space, each arrow is its force as the camera sees it: the weight, the spring (k times the
/// overlap with the plane, along its normal), and the damper, which is the rest of the force.
template <class Scene, class Phases>
Seen check_arrows_in_space(const test::Values& settings, const Plane& plane) {
  using Run = OneBallRun<Scene, Phases>;
  const Demo demo = space_demo<Scene, Phases>();
  auto run =
      std::make_unique<Run>(run_with<Run>(settings, methods::semi_implicit_euler, small_step));
  const Scene scene = run->scene();
  BallInSpace look;
  look.radius = scene.radius;
  look.plane = plane;
  const Vector3d gravity(0, -scene.mass * scene.gravity, 0);
  Playback playback(std::move(run));
  Seen seen;
  for (int step = 0; step < steps_a_run; ++step) {
    if (passes_over(playback, step)) continue;
    const RecordingCanvas canvas = picture_of(demo, playback);
    const Camera camera = camera_for(playback, look, layout::scene, false);
    const Vector3d ball = state_in<Vector3d>(playback.shown_values()).position;
    const Vector3d force = force_of_step<Vector3d>(playback, scene.mass);
    const double overlap = std::max(0.0, scene.radius - plane.distance(ball));
    const Vector3d spring = scene.stiffness * overlap * plane.normal;
    const Vector3d damper = force - gravity - spring;
    CAPTURE(step);
    const auto check = [&](Colour colour, const Vector3d& expected, const Vector3d& foot) {
      const double length = pixels(expected.norm(), gravity.norm());
      const Vector3d end =
          foot + length / static_cast<double>(camera.per_metre(foot)) * expected.normalized();
      const Point from = camera.at(foot), to = camera.at(end);
      const float x = to.x - from.x, up = from.y - to.y;
      const auto drawn = std::find_if(canvas.arrows.begin(), canvas.arrows.end(),
                                      [&](const Arrow& a) { return same(a.colour, colour); });
      if (drawn == canvas.arrows.end()) {
        REQUIRE(std::hypot(x, up) < 6 + pixel_error);
      } else {
        REQUIRE(std::abs(drawn->x() - x) < pixel_error);
        REQUIRE(std::abs(drawn->up() - up) < pixel_error);
      }
    };
    check(palette::gravity, gravity, ball);
    check(palette::spring, spring, plane.foot(ball));
    check(palette::damper, damper, plane.foot(ball));
    ++(overlap > 0 ? seen.contact : seen.flight);
  }
  return seen;
}

}  // namespace

TEST_CASE("the arrows of stages 1 to 3 and 6 are the force that moves the ball") {
  const Seen fall = check_arrows_on_a_line<FreeFall, FreeFallExact>({});
  CHECK(fall.flight > 20);
  CHECK(check_arrows_on_a_line<SpringFloor, SpringFloorExact>({}).contact > 20);
  for (const char* contact : {"may-pull", "push-only"}) {
    CAPTURE(contact);
    const Seen damped =
        check_arrows_on_a_line<Damping, DampingExact>({{"contact", contact}, {"damping", "60"}});
    CHECK(damped.contact > 20);
    for (const char* law : {"relative", "absolute", "fixed-switch"}) {
      CAPTURE(law);
      const Seen moved = check_arrows_on_a_line<OscillatingFloor, OscillatingFloorExact>(
          {{"contact", contact}, {"floor_law", law}, {"damping", "20"}, {"floor_velocity", "0.1"}});
      CHECK(moved.contact > 20);
      CHECK(moved.flight > 20);
    }
  }
}

TEST_CASE("the arrows of stages 4 and 7 are the force that moves the ball") {
  for (const char* contact : {"may-pull", "push-only"}) {
    CAPTURE(contact);
    const Seen level = check_arrows_in_space<ThreeDimensions, ThreeDimensionsExact>(
        {{"contact", contact}, {"damping", "60"}}, Plane{});
    CHECK(level.contact > 20);
    const Vector3d normal(0.3, 1, -0.2);
    const Seen tilted = check_arrows_in_space<TiltedPlane, TiltedPlaneExact>(
        {{"contact", contact}, {"damping", "60"}, {"normal", test::text(normal)}},
        Plane::from_equation(normal, 0));
    CHECK(tilted.contact > 20);
  }
}

TEST_CASE("the arrows between two balls of stage 5 are the force that moves them") {
  Demo demo;
  demo.make = [] { return std::make_unique<BallsRun>(); };
  use_balls_picture(demo);
  for (const char* contact : {"may-pull", "push-only"}) {
    auto run = std::make_unique<BallsRun>(
        run_with<BallsRun>({{"scene", "pair"}, {"contact", contact}, {"damping", "60"}},
                           methods::semi_implicit_euler, small_step));
    const BallCollision scene = run->scene();
    Playback playback(std::move(run));
    int touching = 0;
    CAPTURE(contact);
    for (int step = 0; step < steps_a_run; ++step) {
      CAPTURE(step);
      if (passes_over(playback, step)) continue;
      const RecordingCanvas canvas = picture_of(demo, playback);
      const Camera camera = camera_for(playback, View{});
      const Balls before = balls_in(playback.shown_values());
      playback.step_forward();
      const Balls after = balls_in(playback.shown_values());
      const Vector3d change = after.velocity.col(0) - before.velocity.col(0);
      const Vector3d force = scene.mass[0] * change / small_step;  // of ball 1 on ball 0
      std::vector<Arrow> drawn;
      for (const Arrow& arrow : canvas.arrows) {
        if (same(arrow.colour, palette::spring)) drawn.push_back(arrow);
      }
      if (force.norm() < 1e-9) {
        REQUIRE(drawn.empty());
        continue;
      }
      // At the point of ball 0 that is nearest to ball 1, one arrow for each; 2 cm for 1 N.
      const Vector3d place = before.position.col(0);
      const Vector3d between = (before.position.col(1) - place).normalized();
      const Vector3d touch = place + scene.radius[0] * between;
      const Vector3d arrow = std::min(0.5, 0.02 * std::sqrt(force.norm())) * force.normalized();
      const Point foot = camera.at(touch), to = camera.at(touch + arrow),
                  back = camera.at(touch - arrow);
      if (std::hypot(to.x - foot.x, to.y - foot.y) < 7) continue;  // a dot, or nearly
      REQUIRE(drawn.size() == 2);
      CHECK(std::abs(drawn[0].to.x - to.x) + std::abs(drawn[0].to.y - to.y) < 2 * pixel_error);
      CHECK(std::abs(drawn[1].to.x - back.x) + std::abs(drawn[1].to.y - back.y) < 2 * pixel_error);
      ++touching;
    }
    CHECK(touching > 10);
  }
}
