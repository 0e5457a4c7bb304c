#include "05_ball_collision/picture/balls_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "05_ball_collision/picture/balls_marks.hpp"
#include "05_ball_collision/picture/cover.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {
namespace {

using Eigen::Vector3d;

constexpr int few = 40;       // up to so many balls have shadows and can be dragged,
constexpr int very_few = 16;  // and so many have trails, arrows and numbers

/// What the camera looks at, and how much of it fits into the picture [m].
struct Framing {
  Vector3d centre;
  double size;
  double steepness = 0.30;  // how far from above
};

Framing framing_of(const BallsRun& balls) {
  if (balls.world().own_balls) {
    const Arrangement& start = *balls.world().own_balls;
    const Vector3d low = start.balls.position.rowwise().minCoeff();
    const Vector3d high = start.balls.position.rowwise().maxCoeff();
    return {(low + high) / 2, 2 * (high - low).norm() + 6 * start.radius.maxCoeff()};
  }
  const double width = std::max(balls.scene().tray[0], balls.scene().tray[1]);
  switch (balls.world().choice.scene) {
    case BallScene::pair:
      return {{0, 0.1, 0}, 1.6};
    case BallScene::break_up:
      return {{0.4, 0, 0}, 3.0, 1.1};
    case BallScene::cradle:
      return {{0, 0.1, 0}, 1.5};
    case BallScene::tower:
      return {{0, 3.3, 0}, 7.6, 0.12};
    case BallScene::drop:
      break;
  }
  if (width == 0) {
    const double count = static_cast<double>(balls.balls());
    return {{0.1 * std::sqrt(count) / 2, 0.3, 0.1 * std::sqrt(count) / 2}, 0.3 * std::sqrt(count)};
  }
  return {{balls.scene().tray[0] / 2, 0.35 * width, balls.scene().tray[1] / 2}, 1.65 * width, 0.45};
}

/// Grey at rest, blue when fast. "Fast" is the speed at which all balls together would have the
/// energy of the start.
Colour colour_of(double speed, double fast) {
  constexpr Colour slow{0xF4, 0xF6, 0xF8}, quick{0x2A, 0x8F, 0xD6};
  return slow.towards(quick, std::clamp(speed / fast, 0.0, 1.0));
}

void draw_tray(Canvas& canvas, const Camera& camera, const BallCollision& scene, double height) {
  const double lx = scene.tray[0], lz = scene.tray[1];
  if (!(lx > 0 && lz > 0)) return;
  const std::array<Vector3d, 4> foot{
      {{0, 0, lz}, {0, 0, 0}, {lx, 0, 0}, {lx, 0, lz}}};  // from the left front around the back
  const Vector3d up(0, height, 0);
  for (std::size_t i = 0; i + 1 < foot.size(); ++i) {  // the front one would hide the balls
    const std::array<Vector3d, 4> wall{{foot[i], foot[i + 1], foot[i + 1] + up, foot[i] + up}};
    draw_patch(canvas, camera, wall, palette::exact.faded(0.10));
  }
  const std::array<Vector3d, 5> bottom{{foot[0], foot[1], foot[2], foot[3], foot[0]}};
  draw_path(canvas, camera, bottom, palette::exact, 1.5f);
  std::array<Vector3d, 4> rim{{foot[0] + up, foot[1] + up, foot[2] + up, foot[3] + up}};
  draw_path(canvas, camera, rim, palette::exact.faded(0.6), 1);
}

void draw_balls(Canvas& canvas, const Camera& camera, const Playback& playback, const View& view) {
  const BallsRun& simulation = balls_of(playback);
  const BallCollision& scene = simulation.scene();
  const Balls balls = balls_in(playback.shown_values());
  const Eigen::Index count = balls.position.cols();
  const Framing framing = framing_of(simulation);

  const Plane ground{};
  if (scene.floor) {
    const double square = framing.size > 4 ? 0.5 : 0.1;
    const Vector3d middle(framing.centre.x(), 0, framing.centre.z());
    draw_plane_grid(canvas, camera, ground, middle, square,
                    std::min(1.2 * framing.size, 30 * square));
  }
  draw_tray(canvas, camera, scene, 0.5 * scene.tray[0]);
  if (scene.floor && count <= few) {
    for (Eigen::Index i = 0; i < count; ++i) {
      draw_shadow(canvas, camera, ground, balls.position.col(i), scene.radius[i]);
    }
  }
  if (count <= very_few) {
    draw_futures(canvas, camera, view.earlier, count, true);
    draw_futures(canvas, camera, view.future, count, false);
    if (view.trail) draw_trails(canvas, camera, playback, count);
  }
  // From near to far to leave out what is hidden, and then drawn from far to near.
  struct Visible {
    double depth;
    Point centre;
    float radius;
    double speed;
  };
  std::vector<Visible> seen;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto [centre, v, radius] = scene.ball(balls, i);
    if (!camera.sees(centre)) continue;
    const float size = std::max(2.0f, static_cast<float>(radius) * camera.per_metre(centre));
    seen.push_back({camera.depth(centre), camera.at(centre), size, v.norm()});
  }
  std::sort(seen.begin(), seen.end(),
            [](const Visible& a, const Visible& b) { return a.depth < b.depth; });
  Cover cover(layout::scene);
  std::erase_if(seen, [&](const Visible& ball) { return !cover.add(ball.centre, ball.radius); });
  const double mass = scene.mass.sum();
  const double fast =
      std::sqrt(2 * std::max(std::abs(simulation.energy_account().before), 1e-12) / mass);
  for (auto ball = seen.rbegin(); ball != seen.rend(); ++ball) {
    canvas.ball(ball->centre, ball->radius, colour_of(ball->speed, fast));
  }
  if (view.ghost) {
    draw_ghosts(canvas, camera, scene, balls_in(simulation.exact_values(playback.shown_time())));
  }
  if (count <= very_few) {
    if (view.forces) draw_arrows(canvas, camera, scene, balls);
    draw_numbers(canvas, camera, playback, balls);
  }
}

/// Which ball is under the mouse: the nearest of those.
std::optional<Eigen::Index> ball_under(const Playback& playback, const View& view, Point at) {
  const Camera camera = camera_for(playback, view);
  const Balls balls = balls_in(playback.shown_values());
  std::optional<Eigen::Index> found;
  double nearest = 1e300;
  for (Eigen::Index i = 0; i < balls.position.cols(); ++i) {
    const auto [centre, v, radius] = balls_of(playback).scene().ball(balls, i);
    if (!camera.sees(centre)) continue;
    const Point pixel = camera.at(centre);
    const float reach = std::max(10.0f, static_cast<float>(radius) * camera.per_metre(centre));
    if (std::hypot(pixel.x - at.x, pixel.y - at.y) > reach || camera.depth(centre) > nearest)
      continue;
    nearest = camera.depth(centre);
    found = i;
  }
  return found;
}

void move_ball(Playback& playback, const View& view, Eigen::Index ball, Point to, Point speed) {
  const Camera camera = camera_for(playback, view);
  const Vector3d like = balls_in(playback.shown_values()).position.col(ball);
  const Vector3d place = camera.under(to, like);
  Vector3d v = camera.across(speed, like);
  if (v.norm() > fastest_throw) v *= fastest_throw / v.norm();
  playback.change([&](Simulation& simulation) {
    const BallsRun& run = run_as<BallsRun>(simulation);
    Balls balls = run.state();
    balls.position.col(ball) = place;
    balls.velocity.col(ball) = v;
    simulation.place(run.world().row(run.time(), balls));
  });
}

}  // namespace

Camera camera_for(const Playback& playback, const View& view) {
  const Framing framing = framing_of(balls_of(playback));
  const double distance = framing.size / 2 / std::tan(usual_opening * std::numbers::pi / 360);
  return camera_before(framing.centre, distance, framing.steepness, layout::scene, view.from_above);
}

void use_balls_picture(Demo& demo) {
  demo.in_space = true;
  demo.picture = [](const Playback& playback, const View& view, Canvas& canvas) {
    canvas.push_clip(layout::scene);
    const Camera camera = camera_for(playback, view);
    draw_balls(canvas, camera, playback, view);
    draw_axes(canvas, camera, {46, layout::scene.bottom() - 40});
    canvas.pop_clip();
  };
  demo.is_over = [](const Playback& playback) {  // on the table all have left the picture by then
    const BallsRun& balls = balls_of(playback);
    const bool on_table =
        balls.world().choice.scene <= BallScene::cradle && !balls.world().own_balls;
    return on_table && balls.scene().gravity == 0 && playback.shown_time() > 6;
  };
  const auto held = std::make_shared<Eigen::Index>(0);
  demo.is_on_ball = [held](const Playback& playback, const View& view, Point at) {
    if (balls_of(playback).balls() > few) return false;
    const std::optional<Eigen::Index> ball = ball_under(playback, view, at);
    if (ball) *held = *ball;
    return ball.has_value();
  };
  demo.drag = [held](Playback& playback, const View& view, Point at, Point speed) {
    move_ball(playback, view, *held, at, speed);
  };
}

}  // namespace bounce
