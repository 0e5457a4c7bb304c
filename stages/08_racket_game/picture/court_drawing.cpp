#include "08_racket_game/picture/court_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"
#include "run/rows.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double trail_lasts = 0.35;      // s
constexpr Colour face{0xBF, 0xD3, 0xE2};  // of the racket
constexpr Colour back{0x9A, 0xAF, 0xBE};

/// A circle in space, around `centre`, square to `normal`.
std::vector<Vector3d> circle(const Vector3d& centre, const Vector3d& normal, double radius,
                             int corners = 64) {
  const auto [along, across] = axes_of(Plane{normal, 0});
  std::vector<Vector3d> points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * across));
  }
  return points;
}

Colour mixed(Colour from, Colour to, double share) {
  const auto mix = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + share * (b - a));
  };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue), 255};
}

}  // namespace

void draw_floor(Canvas& canvas, const Camera& camera, const Plane& floor, const Vector3d& centre) {
  constexpr double square = 0.5;  // m
  constexpr int reach = 6;        // squares
  const double height = -floor.offset;
  const double first_x = square * std::round(centre.x() / square);
  const double first_z = square * std::round(centre.z() / square);
  const auto line = [&](double x1, double z1, double x2, double z2) {
    const double away = std::hypot((x1 + x2) / 2 - centre.x(), (z1 + z2) / 2 - centre.z());
    const double share = 1 - away / (reach * square);
    if (share <= 0) return;
    const std::array<Vector3d, 2> ends{Vector3d(x1, height, z1), Vector3d(x2, height, z2)};
    draw_path(canvas, camera, ends, palette::exact.faded(0.5 * share), 1);
  };
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j < reach; ++j) {
      const double a = square * i, b = square * j, c = square * (j + 1);
      line(first_x + a, first_z + b, first_x + a, first_z + c);
      line(first_x + b, first_z + a, first_x + c, first_z + a);
    }
  }
}

void draw_disc(Canvas& canvas, const Camera& camera, const Disc& disc, bool from_front,
               double glow) {
  const std::vector<Vector3d> rim = circle(disc.centre, disc.normal, disc.radius);
  const Colour fill = mixed(from_front ? face : back, palette::spring, 0.6 * glow);
  draw_patch(canvas, camera, rim, {fill.red, fill.green, fill.blue, 235});
  const auto inner = circle(disc.centre, disc.normal, disc.radius / 2, 48);
  draw_path(canvas, camera, inner, palette::motion.faded(0.35), 1);
  draw_path(canvas, camera, rim, palette::motion, 3);
}

void draw_disc_shadow(Canvas& canvas, const Camera& camera, const Disc& disc, double floor) {
  std::vector<Vector3d> shadow = circle(disc.centre, disc.normal, disc.radius, 40);
  for (Vector3d& point : shadow) point.y() = floor;
  draw_patch(canvas, camera, shadow, palette::ink.faded(0.10));
}

void draw_landing(Canvas& canvas, const Camera& camera, const Court& court) {
  const double height = court.racket.disc.centre.y(), radius = court.racket.radius;
  const Landing next = landing(court.ball, court.racket.gravity, height + radius);
  if (next.after == never || next.after > 3) return;
  Vector3d place = next.place;
  place.y() = height + 0.004;
  const double size = radius * (0.5 + 1.5 * std::min(1.0, next.after));
  draw_path(canvas, camera, circle(place, Vector3d::UnitY(), size, 40), palette::damper, 2);
  for (const Vector3d& arm : {Vector3d(0.05, 0, 0), Vector3d(0, 0, 0.05)}) {
    const std::array<Vector3d, 2> line{place - arm, place + arm};
    draw_path(canvas, camera, line, palette::damper, 2);
  }
}

void draw_game_trail(Canvas& canvas, const Camera& camera, const Playback& playback) {
  const double now = playback.shown_time();
  std::vector<Vector3d> path;
  std::vector<double> ages;
  for (auto point = playback.trace().rbegin(); point != playback.trace().rend(); ++point) {
    if (now - point->t > trail_lasts) break;
    path.push_back(state_in<Vector3d>(point->values).position);
    ages.push_back((now - point->t) / trail_lasts);
  }
  for (std::size_t i = 0; i + 4 < path.size(); i += 4) {
    const std::array<Vector3d, 2> piece{path[i], path[i + 4]};
    const double share = std::clamp(1 - ages[i], 0.0, 1.0);
    draw_path(canvas, camera, piece, palette::motion.faded(0.55 * share),
              static_cast<float>(2 + 5 * share));
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
