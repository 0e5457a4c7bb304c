#include "08_racket_game/picture/court_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "08_racket_game/run/bare_racket.hpp"
#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

/// A circle in space, around `centre`, square to `normal`.
std::vector<Vector3d> circle(const Vector3d& centre, const Vector3d& normal, double radius,
                             int corners) {
  const auto [along, across] = axes_of(Plane{normal, 0});
  std::vector<Vector3d> points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * across));
  }
  return points;
}

namespace {

constexpr Colour face{0xCB, 0xD3, 0xDA};  // of the racket
constexpr Colour back{0xA6, 0xAF, 0xB8};
constexpr Colour rim_grey{0x3A, 0x44, 0x4E};

}  // namespace

Court court_of(const Simulation& simulation) {
  Court court;
  court.ball = state_in<Vector3d>(simulation.values());
  if (const GameRun* game = run_if<GameRun>(simulation)) {
    court.game = game;
    court.racket = game->scene_now();
    court.home = game->settings().racket.disc.centre;
  } else {
    const BareRacketWorld& world = run_as<BareRacketRun>(simulation).world();
    court.racket = world.scene_now();
    court.racket.disc = world.disc(simulation.time());
    court.home = world.setup.racket.disc.centre;
  }
  return court;
}

void draw_sky(Canvas& canvas, const Camera& camera, Rect area, double floor) {
  constexpr Colour zenith{0xE2, 0xE1, 0xDC};
  constexpr int strips = 12;
  const Vector3d far(0, floor, -1e5);
  const float horizon = std::round(std::clamp(camera.at(far).y, area.y, area.bottom()));
  const float height = std::ceil((horizon - area.y) / strips);
  for (int i = 0; i < strips; ++i) {
    const float top = area.y + static_cast<float>(i) * height;
    if (top >= horizon) break;
    draw_rect(canvas, {area.x, top, area.width, std::min(height, horizon - top)},
              zenith.towards(palette::paper, (i + 0.5) / strips));
  }
  draw_line(canvas, {area.x, horizon}, {area.right(), horizon}, palette::grid_major, 1);
}

void draw_floor(Canvas& canvas, const Camera& camera, double floor, const Vector3d& centre) {
  // Small squares near by, to see movement; and large ones up to far away, to see depth.
  const auto squares = [&](double square, int reach, double strength) {
    const double first_x = square * std::round(centre.x() / square);
    const double first_z = square * std::round(centre.z() / square);
    const auto line = [&](double x1, double z1, double x2, double z2) {
      const double away = std::hypot((x1 + x2) / 2 - centre.x(), (z1 + z2) / 2 - centre.z());
      const double share = 1 - away / (reach * square);
      if (share < 0.1) return;  // not to be seen
      const std::array<Vector3d, 2> ends{Vector3d(x1, floor, z1), Vector3d(x2, floor, z2)};
      draw_path(canvas, camera, ends, palette::exact.faded(strength * share), 1);
    };
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j < reach; j += 2) {
        const double a = square * i, b = square * j, c = square * (j + 2);
        line(first_x + a, first_z + b, first_x + a, first_z + c);
        line(first_x + b, first_z + a, first_x + c, first_z + a);
      }
    }
  };
  squares(0.5, 6, 0.35);
  squares(2, 6, 0.5);
}

void draw_disc(Canvas& canvas, const Camera& camera, const Disc& disc, bool from_front,
               double glow) {
  const std::vector<Vector3d> edge = circle(disc.centre, disc.normal, disc.radius);
  const Colour fill = (from_front ? face : back).towards(accent, 0.35 * glow);
  draw_patch(canvas, camera, edge, {fill.red, fill.green, fill.blue, 235});
  const auto inner = circle(disc.centre, disc.normal, disc.radius / 2, 48);
  draw_path(canvas, camera, inner, rim_grey.faded(0.4), 1);
  draw_path(canvas, camera, edge, rim_grey, 3);
}

void draw_disc_shadow(Canvas& canvas, const Camera& camera, const Disc& disc, double floor) {
  std::vector<Vector3d> shadow = circle(disc.centre, disc.normal, disc.radius, 40);
  for (Vector3d& point : shadow) point.y() = floor;
  draw_patch(canvas, camera, shadow, palette::shadow.faded(0.10));
}

void draw_game_trail(Canvas& canvas, const Camera& camera, std::span<const TrailPoint> trail) {
  for (std::size_t i = 0; i + 4 < trail.size(); i += 4) {
    const double share = std::clamp(1 - trail[i].age / trail_lasts, 0.0, 1.0);
    draw_path(canvas, camera, std::array{trail[i].place, trail[i + 4].place},
              palette::exact.faded(0.55 * share), static_cast<float>(2 + 5 * share));
  }
}

void draw_flattened_ball(Canvas& canvas, const Camera& camera, const Vector3d& centre,
                         double radius, const NearestPoint& nearest) {
  if (!(nearest.distance < radius) || !(nearest.distance > 0.3 * radius) || !camera.sees(centre)) {
    return draw_ball_in_space(canvas, camera, centre, radius);
  }
  const double flat = nearest.distance, wide = radius * std::sqrt(radius / flat);
  const Point at = camera.at(centre), foot = camera.at(centre + nearest.direction * 0.01);
  const float length = std::max(1e-3f, std::hypot(foot.x - at.x, foot.y - at.y));
  const Point up{(foot.x - at.x) / length, (foot.y - at.y) / length};
  const float tall = static_cast<float>(flat) * camera.per_metre(centre);
  const float broad = static_cast<float>(wide) * camera.per_metre(centre);
  std::vector<Point> outline;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    const float a = tall * static_cast<float>(std::sin(angle));
    const float b = broad * static_cast<float>(std::cos(angle));
    outline.push_back({at.x + a * up.x - b * up.y, at.y + a * up.y + b * up.x});
  }
  canvas.fill(outline, palette::ball);
  canvas.line(outline, palette::ink, 1.5f);
}

}  // namespace bounce
