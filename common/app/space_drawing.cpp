#include "app/space_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "app/drawing.hpp"
#include "app/palette.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

/// The part of the line from a to b that the camera sees; nothing when there is none.
std::optional<std::array<Vector3d, 2>> seen_part(const Camera& camera, const Vector3d& a,
                                                 const Vector3d& b) {
  const std::array<double, 5> from = camera.inside(a), to = camera.inside(b);
  double begin = 0, end = 1;  // shares of the way from a to b
  for (std::size_t face = 0; face < from.size(); ++face) {
    if (from[face] >= 0 && to[face] >= 0) continue;
    if (!(from[face] >= 0 || to[face] >= 0)) return std::nullopt;
    const double crossing = from[face] / (from[face] - to[face]);
    if (from[face] < 0) begin = std::max(begin, crossing);
    if (to[face] < 0) end = std::min(end, crossing);
  }
  if (begin > end) return std::nullopt;
  return std::array<Vector3d, 2>{a + begin * (b - a), a + end * (b - a)};
}

/// Calls `draw` with each connected piece of the path that the camera sees.
template <class Draw>
void each_visible_piece(const Camera& camera, std::span<const Vector3d> points, const Draw& draw) {
  std::vector<Point> piece;
  const auto finish = [&] {
    if (piece.size() > 1) draw(piece);
    piece.clear();
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto part = seen_part(camera, points[i], points[i + 1]);
    if (!part) {
      finish();
      continue;
    }
    if (piece.empty()) piece.push_back(camera.at((*part)[0]));
    piece.push_back(camera.at((*part)[1]));
    if (!camera.sees(points[i + 1])) finish();
  }
  finish();
}

}  // namespace

void draw_path(Canvas& canvas, const Camera& camera, std::span<const Vector3d> points,
               Colour colour, float width) {
  each_visible_piece(camera, points,
                     [&](const std::vector<Point>& piece) { canvas.line(piece, colour, width); });
}

void draw_dashed_path(Canvas& canvas, const Camera& camera, std::span<const Vector3d> points,
                      Colour colour, float width) {
  each_visible_piece(camera, points, [&](const std::vector<Point>& piece) {
    draw_dashed(canvas, piece, colour, width);
  });
}

void draw_patch(Canvas& canvas, const Camera& camera, std::span<const Vector3d> corners,
                Colour colour) {
  // Cut at one face of what the camera sees after the other (Sutherland and Hodgman 1974).
  std::vector<Vector3d> patch(corners.begin(), corners.end());
  for (std::size_t face = 0; face < 5; ++face) {
    std::vector<Vector3d> rest;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const Vector3d &corner = patch[i], &next = patch[(i + 1) % patch.size()];
      const double here = camera.inside(corner)[face], there = camera.inside(next)[face];
      if (here >= 0) rest.push_back(corner);
      if ((here >= 0) != (there >= 0))
        rest.push_back(corner + here / (here - there) * (next - corner));
    }
    patch = std::move(rest);
  }
  std::vector<Point> outline;
  for (const Vector3d& corner : patch) outline.push_back(camera.at(corner));
  if (outline.size() > 2) canvas.fill(outline, colour);
}

PlaneAxes axes_of(const Plane& plane) {
  // x without its part along the normal; a wall that faces along x has none: take y there.
  Vector3d along = Vector3d::UnitX() - plane.normal.x() * plane.normal;
  if (along.norm() < 1e-6) along = Vector3d::UnitY() - plane.normal.y() * plane.normal;
  along.normalize();
  return {along, along.cross(plane.normal)};
}

void draw_plane_grid(Canvas& canvas, const Camera& camera, const Plane& plane,
                     const Vector3d& centre, double square, double reach) {
  const auto [along, across] = axes_of(plane);
  const Vector3d origin = plane.foot(Vector3d::Zero());
  const Vector3d middle = plane.foot(centre);

  std::vector<Vector3d> disc;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2 * std::numbers::pi * i / 48;
    disc.push_back(middle + 3 * reach * (std::cos(angle) * along + std::sin(angle) * across));
  }
  draw_patch(canvas, camera, disc, palette::grid_minor.faded(0.75));

  const auto line = [&](const Vector3d& a, const Vector3d& b, bool major) {
    const double distance = ((a + b) / 2 - middle).norm() / reach;
    if (distance >= 1) return;
    const std::array<Vector3d, 2> ends{a, b};
    const double share = (major ? 1.0 : 0.6) * (1 - distance * distance);
    draw_path(canvas, camera, ends, palette::exact.faded(0.55 * share), 1);
  };
  // Grid lines at whole multiples of the square, counted from the plane's own origin.
  const auto count = static_cast<int>(std::ceil(reach / square));
  const auto first_u = std::floor(along.dot(middle - origin) / square);
  const auto first_v = std::floor(across.dot(middle - origin) / square);
  const auto corner = [&, u = along, v = across](int i, int j) -> Vector3d {
    return origin + square * ((first_u + i) * u + (first_v + j) * v);
  };
  const auto is_major = [](double n) { return std::fmod(n, 2) == 0; };
  for (int i = -count; i <= count; ++i) {
    for (int j = -count; j < count; ++j) {
      line(corner(i, j), corner(i, j + 1), is_major(first_u + i));
      line(corner(j, i), corner(j + 1, i), is_major(first_v + i));
    }
  }
}

Vector3d below(const Plane& plane, const Vector3d& point) {
  Vector3d shadow = point;
  shadow.y() -= plane.distance(point) / plane.normal.y();
  return shadow;
}

void draw_shadow(Canvas& canvas, const Camera& camera, const Plane& plane, const Vector3d& ball,
                 double radius) {
  if (plane.normal.y() < 0.05) return;  // the sun does not reach a wall
  const double height = std::max(0.0, plane.distance(ball) - radius);
  const double darkness = 0.34 / (1 + 1.2 * height);
  for (const double size : {1.12, 0.94}) {  // two, for a soft edge
    std::vector<Vector3d> edge;
    for (int i = 0; i < 32; ++i) {
      const double angle = 2 * std::numbers::pi * i / 32;
      const Vector3d out(std::cos(angle), 0, std::sin(angle));
      edge.push_back(below(plane, ball + size * radius * out));
    }
    draw_patch(canvas, camera, edge, palette::shadow.faded(0.85 * darkness / 2));
  }
}

void draw_ball_in_space(Canvas& canvas, const Camera& camera, const Vector3d& centre,
                        double radius) {
  if (!camera.sees(centre)) return;
  const Point at = camera.at(centre);
  const float size = std::max(3.0f, static_cast<float>(radius) * camera.per_metre(centre));
  constexpr Colour dark{0xB4, 0xBE, 0xC8};
  constexpr Colour light = palette::ball;
  canvas.disc(at, size, dark);
  // Discs that shrink towards the light, each a little brighter: a soft shade.
  constexpr int discs = 10;
  for (int i = 1; i <= discs; ++i) {
    const float share = static_cast<float>(i) / discs;
    const float shift = 0.30f * share * size;
    canvas.disc({at.x - shift, at.y - shift}, size * (1 - 0.62f * share) - 0.5f,
                dark.towards(light, static_cast<double>(share)));
  }
  canvas.disc({at.x - 0.36f * size, at.y - 0.38f * size}, 0.14f * size, {0xF8, 0xFA, 0xFC});
  canvas.circle(at, size, palette::ink, 1.5f);
}

void draw_label_at(Canvas& canvas, const Camera& camera, const Vector3d& place, Point shift,
                   const std::string& words, Colour colour, Align align, TextSize size) {
  if (!camera.sees(place)) return;
  const Point at = camera.at(place);
  draw_label(canvas, {at.x + shift.x, at.y + shift.y}, words, colour, align, size);
}

void draw_axes(Canvas& canvas, const Camera& camera, Point origin) {
  constexpr float length = 34;
  constexpr std::array<std::pair<const char*, int>, 3> names{{{"x", 0}, {"y", 1}, {"z", 2}}};
  for (const auto& [name, i] : names) {
    const Vector3d axis = Vector3d::Unit(i);
    const Point arrow{static_cast<float>(camera.right().dot(axis)) * length,
                      static_cast<float>(-camera.up().dot(axis)) * length};
    if (std::hypot(arrow.x, arrow.y) < 4) continue;  // it points at the camera
    const Point tip{origin.x + arrow.x, origin.y + arrow.y};
    draw_arrow(canvas, origin, tip, palette::exact);
    const float away = 1 + 11 / std::hypot(arrow.x, arrow.y);
    canvas.text({origin.x + arrow.x * away, origin.y + arrow.y * away - 8}, name, palette::ink,
                Align::centre, TextSize::tick);
  }
}

}  // namespace bounce
