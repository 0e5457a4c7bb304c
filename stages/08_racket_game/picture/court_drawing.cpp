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
#include "run/rows.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

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

void draw_goal(Canvas& canvas, const Camera& camera, const Court& court) {
  const Settings& settings = court.game->settings();
  const Vector3d home = court.home;
  if (settings.mode == Settings::keep_up) {
    const auto corner = [&](double x, double up) -> Vector3d { return home + Vector3d(x, up, 0); };
    constexpr double half = 0.5, low = rules::band_low, high = rules::band_high;  // m
    const std::array<Vector3d, 4> band{corner(-half, low), corner(half, low), corner(half, high),
                                       corner(-half, high)};
    draw_patch(canvas, camera, band, palette::spring.faded(0.10));
    for (const double edge : {low, high}) {
      const std::array<Vector3d, 2> line{corner(-half, edge), corner(half, edge)};
      draw_dashed_path(canvas, camera, line, palette::spring.faded(0.6), 1);
    }
    if (const Vector3d side = corner(half, low); camera.sees(side)) {
      draw_label(canvas, {camera.at(side).x + 8, camera.at(side).y - 20}, "a top here: + 1",
                 palette::spring);
    }
  }
  if (settings.mode == Settings::target) {
    const Round& round = court.game->round();
    Vector3d middle = aim_after(round.score.hits, settings, round);
    middle.y() += 0.006;
    for (const double radius : {0.1, 0.2, 0.35}) {
      draw_path(canvas, camera, circle(middle, Vector3d::UnitY(), radius, 48), palette::spring,
                radius < 0.15 ? 3.0f : 1.5f);
    }
    if (camera.sees(middle)) {
      draw_label(canvas, {camera.at(middle).x + 8, camera.at(middle).y - 8}, "send it here",
                 palette::spring);
    }
  }
}

void draw_beat(Canvas& canvas, Point centre, double phase, double flash) {
  constexpr float radius = 54;
  if (flash > 0) canvas.disc(centre, radius, palette::spring.faded(0.7 * flash));
  canvas.circle(centre, radius, palette::ink, 2);
  const std::array<Point, 2> top{Point{centre.x, centre.y - radius - 10},
                                 Point{centre.x, centre.y - radius + 10}};
  canvas.line(top, palette::ink, 4);
  const auto angle = static_cast<float>(2 * std::numbers::pi * phase);
  const Point tip{centre.x + radius * std::sin(angle), centre.y - radius * std::cos(angle)};
  const std::array<Point, 2> hand{centre, tip};
  canvas.line(hand, palette::spring, 4);
  canvas.text({centre.x, centre.y + radius + 10}, "swing when it is up", palette::ink,
              Align::centre, TextSize::normal);
}

void draw_game_trail(Canvas& canvas, const Camera& camera, std::span<const TrailPoint> trail) {
  for (std::size_t i = 0; i + 4 < trail.size(); i += 4) {
    const std::array<Vector3d, 2> piece{trail[i].place, trail[i + 4].place};
    const double share = std::clamp(1 - trail[i].age / trail_lasts, 0.0, 1.0);
    draw_path(canvas, camera, piece, palette::motion.faded(0.55 * share),
              static_cast<float>(2 + 5 * share));
  }
}

void draw_arrows(Canvas& canvas, const Camera& camera, const Court& court, const Moment& now,
                 const Moment* touch) {
  const auto arrow = [&](const Vector3d& from, const Vector3d& to, Colour colour, Shaft shaft) {
    if (!camera.sees(from) || !camera.sees(to)) return;
    draw_arrow(canvas, camera.at(from), camera.at(to), colour, shaft);
  };
  if (touch != nullptr && camera.sees(touch->nearest.point)) {
    const Vector3d at = touch->nearest.point;
    for (const Vector3d& arm : {Vector3d(0.04, 0, 0.04), Vector3d(0.04, 0, -0.04)}) {
      const std::array<Vector3d, 2> line{at - arm, at + arm};
      draw_path(canvas, camera, line, palette::ink, 2);
    }
    const double weight = court.racket.mass * court.racket.gravity;
    if (weight > 0 && touch->push.norm() > 0) {
      const double length = 0.06 * std::sqrt(touch->push.norm() / weight);
      const Vector3d tip = at + length * touch->push.normalized();
      arrow(at, tip, palette::spring, Shaft::force);
      if (camera.sees(tip)) {
        draw_label(canvas, {camera.at(tip).x + 12, camera.at(tip).y - 8},
                   "push " + with_unit(touch->push.norm(), "N"), palette::spring);
      }
    }
    draw_label(canvas, {camera.at(at).x + 14, camera.at(at).y + 8}, "touch", palette::ink);
  }
  const Vector3d ball = now.ball.position, tip = ball + 0.15 * now.ball.velocity;
  arrow(ball, tip, palette::motion, Shaft::velocity);
  if (camera.sees(tip)) {
    draw_label(canvas, {camera.at(tip).x + 14, camera.at(tip).y - 6},
               with_unit(now.ball.velocity.norm(), "m/s"), palette::motion);
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
