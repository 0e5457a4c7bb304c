#include "05_ball_collision/picture/balls_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "05_ball_collision/picture/cover.hpp"
#include "05_ball_collision/run/balls_world.hpp"
#include "app/camera.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {
namespace {

using Eigen::Vector3d;

constexpr int few = 40;               // up to so many balls have shadows and can be dragged,
constexpr int very_few = 16;          // and so many have trails, arrows and numbers
constexpr double opening = 34;        // degrees
constexpr double trail_length = 1.2;  // s
constexpr double fastest_throw = 8;   // m/s

const BallsRun& balls_of(const Player& player) { return run_as<BallsRun>(player.simulation()); }

Vector3d position(const std::vector<double>& rows, std::size_t ball) {
  return {rows[7 * ball + 1], rows[7 * ball + 2], rows[7 * ball + 3]};
}
Vector3d velocity(const std::vector<double>& rows, std::size_t ball) {
  return {rows[7 * ball + 4], rows[7 * ball + 5], rows[7 * ball + 6]};
}

/// What the camera looks at, and how much of it fits into the picture [m].
struct Sight {
  Vector3d centre;
  double size;
  double steepness = 0.30;  // how far from above
};

Sight sight_of(const BallsRun& balls) {
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

Camera camera_for(const Player& player, const View& view) {
  const Sight sight = sight_of(balls_of(player));
  const double distance = sight.size / 2 / std::tan(opening * std::numbers::pi / 360);
  if (view.from_above) {
    const Vector3d eye = sight.centre + Vector3d(0, 20 * distance, 0);
    return {eye, sight.centre, {0, 0, -1}, layout::scene, opening / 20};
  }
  const Vector3d direction = Vector3d(-0.10, sight.steepness, 0.95).normalized();
  return {sight.centre + distance * direction, sight.centre, {0, 1, 0}, layout::scene, opening};
}

/// Grey at rest, blue when fast. "Fast" is the speed at which all balls together would have the
/// energy of the start.
Colour colour_of(double speed, double fast) {
  const double share = std::clamp(speed / fast, 0.0, 1.0);
  const auto mix = [share](std::uint8_t slow, std::uint8_t quick) {
    return static_cast<std::uint8_t>(slow + share * (quick - slow));
  };
  constexpr Colour slow{0xF4, 0xF6, 0xF8}, quick{0x2A, 0x8F, 0xD6};
  return {mix(slow.red, quick.red), mix(slow.green, quick.green), mix(slow.blue, quick.blue)};
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

void draw_trails(Canvas& canvas, const Camera& camera, const Player& player, std::size_t balls) {
  for (std::size_t ball = 0; ball < balls; ++ball) {
    std::vector<Vector3d> path;
    for (const TracePoint& point : player.trace()) {
      if (point.t < player.shown_time() - trail_length || point.t > player.shown_time()) continue;
      if (point.values.size() == 7 * balls) path.push_back(position(point.values, ball));
    }
    for (std::size_t i = 0; i + 1 < path.size(); i += 24) {
      const std::size_t count = std::min<std::size_t>(25, path.size() - i);
      const double age = 1 - static_cast<double>(i) / static_cast<double>(path.size());
      draw_path(canvas, camera, std::span(path).subspan(i, count),
                palette::motion.faded(0.7 * (1 - 0.85 * age)), 1.5f);
    }
  }
}

void draw_futures(Canvas& canvas, const Camera& camera, const std::vector<TracePoint>& future,
                  std::size_t balls, bool earlier) {
  for (std::size_t ball = 0; ball < balls; ++ball) {
    std::vector<Vector3d> path;
    for (const TracePoint& point : future) {
      if (point.values.size() == 7 * balls) path.push_back(position(point.values, ball));
    }
    if (earlier) draw_dashed_path(canvas, camera, path, palette::exact.faded(0.5), 1);
    if (!earlier) draw_path(canvas, camera, path, palette::motion.faded(0.3), 2);
  }
}

/// Where the exact solution has the balls: pale rings.
void draw_ghosts(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const std::vector<double>& exact) {
  for (std::size_t ball = 0; 7 * ball < exact.size(); ++ball) {
    const Vector3d at = position(exact, ball);
    if (!camera.sees(at)) continue;
    const double radius = scene.radius[static_cast<Eigen::Index>(ball)];
    const auto size = static_cast<float>(radius * camera.per_metre(at));
    draw_dashed_circle(canvas, camera.at(at), std::max(3.0f, size), palette::exact, 1.5f);
  }
}

/// Velocities, and while balls touch, the force on each of a pair.
void draw_arrows(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const std::vector<double>& rows, std::size_t balls) {
  const auto at = [&](std::size_t i) {
    return Ball{position(rows, i), velocity(rows, i), scene.radius[static_cast<Eigen::Index>(i)]};
  };
  for (std::size_t i = 0; i < balls; ++i) {
    const Ball ball = at(i);
    const Vector3d tip = ball.position + 0.25 * ball.velocity;
    if (!camera.sees(ball.position) || !camera.sees(tip) || ball.velocity.norm() < 0.02) continue;
    draw_arrow(canvas, camera.at(ball.position), camera.at(tip), palette::motion, Shaft::velocity);
  }
  for (std::size_t i = 0; i < balls; ++i) {
    for (std::size_t j = i + 1; j < balls; ++j) {
      const Vector3d force = pair_force(at(i), at(j), scene.pair_contact());
      const Vector3d touch = at(i).position - at(i).radius * meet(at(i), at(j)).e12;
      if (force.isZero() || !camera.sees(touch)) continue;
      const Vector3d arrow = force.normalized() * std::min(0.5, 0.02 * std::sqrt(force.norm()));
      draw_arrow(canvas, camera.at(touch), camera.at(touch + arrow), palette::spring);
      draw_arrow(canvas, camera.at(touch), camera.at(touch - arrow), palette::spring);
    }
  }
}

/// In rows: the speed under each ball. In the tower: how high the small ball came.
void draw_numbers(Canvas& canvas, const Camera& camera, const Player& player,
                  const std::vector<double>& rows, std::size_t balls) {
  const BallsRun& simulation = balls_of(player);
  char text[64];
  if (simulation.world().own_balls) return;
  if (simulation.world().choice.scene == BallScene::cradle || balls == 2) {
    for (std::size_t i = 0; i < balls && balls <= 7; ++i) {
      const double radius = simulation.scene().radius[static_cast<Eigen::Index>(i)];
      const Vector3d foot = position(rows, i) - Vector3d(0, radius, 0);
      if (!camera.sees(foot)) continue;
      const bool row = simulation.world().choice.scene == BallScene::cradle;
      const Vector3d v = velocity(rows, i);
      double speed = row ? v.x() : v.norm();
      if (std::abs(speed) < 5e-4) speed = 0;  // and not -0.000
      std::snprintf(text, sizeof text, row ? "%+.3f m/s" : "%.2f m/s", speed);
      const Point at = camera.at(foot);
      if (simulation.world().choice.scene == BallScene::tower) {
        draw_label(canvas, {at.x + 34, at.y - 20}, text, palette::ink);
      } else {
        draw_label(canvas, {at.x, at.y + 12}, text, palette::ink, Align::centre);
      }
    }
  }
  if (simulation.world().choice.scene != BallScene::tower) return;
  // Heights of the small ball's centre above where it is when both lie on the floor, in falls.
  const double lying = 2 * simulation.scene().radius[0] + simulation.scene().radius[1];
  constexpr double fall = 0.8;
  const auto mark = [&](double height, const std::string& words, Colour colour) {
    const std::array<Vector3d, 2> line{{{-0.6, height, 0}, {0.6, height, 0}}};
    draw_dashed_path(canvas, camera, line, colour, 1.5f);
    const Point end = camera.at(line[1]);
    draw_label(canvas, {end.x + 8, end.y - 9}, words, palette::ink, Align::left, TextSize::normal);
  };
  mark(lying + fall, "1 x the fall", palette::exact);
  mark(lying + 6.95 * fall, "6.95 x: two collisions, one after the other", palette::exact);
  double top = 0;
  bool thrown = false, over = false;
  for (const TracePoint& point : player.trace()) {
    if (point.values.size() < 14 || point.t > player.shown_time()) continue;
    const double up = velocity(point.values, 1).y();
    thrown = thrown || up > 1;
    over = over || (thrown && up < -0.01);
    if (thrown && !over) top = std::max(top, position(point.values, 1).y());
  }
  if (top < lying) return;
  std::snprintf(text, sizeof text, "%.2f x", (top - lying) / fall);
  const Vector3d at(-0.7, top, 0);
  if (!camera.sees(at)) return;
  const std::array<Vector3d, 2> line{{{-0.6, top, 0}, {0.2, top, 0}}};
  draw_path(canvas, camera, line, palette::motion, 2);
  draw_label(canvas, {camera.at(at).x, camera.at(at).y - 9}, text, palette::ink, Align::right,
             TextSize::title);
}

void draw_balls(Canvas& canvas, const Camera& camera, const Player& player, const View& view) {
  const BallsRun& simulation = balls_of(player);
  const BallCollision& scene = simulation.scene();
  const std::vector<double> rows = player.shown_values();
  const std::size_t count = simulation.balls();
  const Sight sight = sight_of(simulation);

  const Plane ground{};
  if (scene.floor) {
    const double square = sight.size > 4 ? 0.5 : 0.1;
    const Vector3d middle(sight.centre.x(), 0, sight.centre.z());
    draw_plane_grid(canvas, camera, ground, middle, square,
                    std::min(1.2 * sight.size, 30 * square));
  }
  draw_tray(canvas, camera, scene, 0.5 * scene.tray[0]);
  const auto radius = [&](std::size_t i) { return scene.radius[static_cast<Eigen::Index>(i)]; };
  if (scene.floor && count <= few) {
    for (std::size_t i = 0; i < count; ++i) {
      draw_shadow(canvas, camera, ground, position(rows, i), radius(i));
    }
  }
  if (count <= very_few) {
    draw_futures(canvas, camera, view.earlier, count, true);
    draw_futures(canvas, camera, view.future, count, false);
    if (view.trail) draw_trails(canvas, camera, player, count);
  }
  // From near to far to leave out what is hidden, and then drawn from far to near.
  struct Seen {
    double depth;
    Point centre;
    float radius;
    double speed;
  };
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d centre = position(rows, i);
    if (!camera.sees(centre)) continue;
    const float size = std::max(2.0f, static_cast<float>(radius(i)) * camera.per_metre(centre));
    seen.push_back({camera.depth(centre), camera.at(centre), size, velocity(rows, i).norm()});
  }
  std::sort(seen.begin(), seen.end(),
            [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
  Cover cover(layout::scene);
  std::erase_if(seen, [&](const Seen& ball) { return !cover.add(ball.centre, ball.radius); });
  const double mass = scene.mass.sum();
  const double fast =
      std::sqrt(2 * std::max(std::abs(simulation.energy_account().before), 1e-12) / mass);
  for (auto ball = seen.rbegin(); ball != seen.rend(); ++ball) {
    canvas.ball(ball->centre, ball->radius, colour_of(ball->speed, fast));
  }
  if (view.ghost) {
    draw_ghosts(canvas, camera, scene, simulation.exact_values(player.shown_time()));
  }
  if (count <= very_few) {
    if (view.forces) draw_arrows(canvas, camera, scene, rows, count);
    draw_numbers(canvas, camera, player, rows, count);
  }
}

/// Which ball is under the mouse: the nearest of those.
std::optional<std::size_t> ball_under(const Player& player, const View& view, Point at) {
  const Camera camera = camera_for(player, view);
  const std::vector<double> rows = player.shown_values();
  std::optional<std::size_t> found;
  double nearest = 1e300;
  for (std::size_t i = 0; i < balls_of(player).balls(); ++i) {
    const Vector3d centre = position(rows, i);
    if (!camera.sees(centre)) continue;
    const Point pixel = camera.at(centre);
    const float radius =
        static_cast<float>(balls_of(player).scene().radius[static_cast<Eigen::Index>(i)]);
    const float reach = std::max(10.0f, radius * camera.per_metre(centre));
    if (std::hypot(pixel.x - at.x, pixel.y - at.y) > reach || camera.depth(centre) > nearest)
      continue;
    nearest = camera.depth(centre);
    found = i;
  }
  return found;
}

void move_ball(Player& player, const View& view, std::size_t ball, Point to, Point speed) {
  const Camera camera = camera_for(player, view);
  const std::vector<double> shown = player.shown_values();
  const Vector3d like = position(shown, ball);
  const Vector3d place = camera.under(to, like);
  Vector3d v = camera.across(speed, like);
  if (v.norm() > fastest_throw) v *= fastest_throw / v.norm();
  player.change([&](Simulation& simulation) {
    std::vector<double> rows = simulation.values();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[7 * ball + 1 + axis] = place[static_cast<Eigen::Index>(axis)];
      rows[7 * ball + 4 + axis] = v[static_cast<Eigen::Index>(axis)];
    }
    simulation.place(rows);
  });
}

}  // namespace

void use_balls_picture(Demo& demo) {
  demo.in_space = true;
  demo.picture = [](const Player& player, const View& view, Canvas& canvas) {
    canvas.push_clip(layout::scene);
    const Camera camera = camera_for(player, view);
    draw_balls(canvas, camera, player, view);
    draw_axes(canvas, camera, {46, layout::scene.bottom() - 40});
    canvas.pop_clip();
  };
  demo.is_over = [](const Player& player) {  // on the table all have left the picture by then
    const BallsRun& balls = balls_of(player);
    const bool on_table =
        balls.world().choice.scene <= BallScene::cradle && !balls.world().own_balls;
    return on_table && balls.scene().gravity == 0 && player.shown_time() > 6;
  };
  const auto held = std::make_shared<std::size_t>(0);
  demo.is_on_ball = [held](const Player& player, const View& view, Point at) {
    if (balls_of(player).balls() > few) return false;
    const std::optional<std::size_t> ball = ball_under(player, view, at);
    if (ball) *held = *ball;
    return ball.has_value();
  };
  demo.drag = [held](Player& player, const View& view, Point at, Point speed) {
    move_ball(player, view, *held, at, speed);
  };
}

}  // namespace bounce
