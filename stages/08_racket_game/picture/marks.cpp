#include "08_racket_game/picture/marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

/// How far beside the disc the ball is, at the disc's height: there the landing is marked, too.
void draw_distance(Canvas& canvas, const Camera& camera, const Court& court) {
  const Vector3d centre = court.racket.disc.centre;
  const Vector3d below(court.ball.position.x(), centre.y(), court.ball.position.z());
  const double distance = (below - centre).norm();
  if (distance < court.racket.disc.radius || !camera.sees(below)) return;
  draw_dashed_path(canvas, camera, std::array{centre, below}, palette::ink, 2);
  draw_label_at(canvas, camera, below, {-34, -8}, with_unit(distance, "m"), palette::ink,
                Align::right);
}

}  // namespace

void draw_landing(Canvas& canvas, const Camera& camera, const Court& court) {
  const double height = court.racket.disc.centre.y(), radius = court.racket.radius;
  const Landing next = landing(court.ball, court.racket.gravity, height + radius);
  if (next.after == never || next.after > 3) return;
  Vector3d place = next.place;
  place.y() = height + 0.004;
  const double size = radius * (0.5 + 1.5 * std::min(1.0, next.after));
  draw_path(canvas, camera, circle(place, Vector3d::UnitY(), size, 40), accent, 2);
  for (const Vector3d& arm : {Vector3d(0.05, 0, 0), Vector3d(0, 0, 0.05)}) {
    draw_path(canvas, camera, std::array<Vector3d, 2>{place - arm, place + arm}, accent, 2);
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
    draw_patch(canvas, camera, band, accent.faded(0.10));
    for (const double edge : {low, high}) {
      draw_dashed_path(canvas, camera, std::array{corner(-half, edge), corner(half, edge)},
                       accent.faded(0.6), 1);
    }
    draw_label_at(canvas, camera, corner(half, low), {8, -20}, "a top here: + 1", accent);
  }
  if (settings.mode == Settings::target) {
    const Round& round = court.game->round();
    Vector3d middle = aim_after(round.score.hits, settings, round);
    middle.y() += 0.006;
    for (const double radius : {0.1, 0.2, 0.35}) {
      draw_path(canvas, camera, circle(middle, Vector3d::UnitY(), radius, 48), accent,
                radius < 0.15 ? 3.0f : 1.5f);
    }
    draw_label_at(canvas, camera, middle + Vector3d(0, 0, 0.4), {0, 0}, "send it here", accent,
                  Align::centre);
  }
}

void draw_beat(Canvas& canvas, Point centre, double phase, double flash) {
  constexpr float radius = 54;
  if (flash > 0) canvas.disc(centre, radius, accent.faded(0.7 * flash));
  canvas.circle(centre, radius, palette::ink, 2);
  const float top = centre.y - radius;
  draw_line(canvas, {centre.x, top - 10}, {centre.x, top + 10}, palette::ink, 4);
  const auto angle = static_cast<float>(2 * std::numbers::pi * phase);
  const Point tip{centre.x + radius * std::sin(angle), centre.y - radius * std::cos(angle)};
  draw_line(canvas, centre, tip, accent, 4);
  canvas.text({centre.x, centre.y + radius + 10}, "swing when it is up", palette::ink,
              Align::centre, TextSize::normal);
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
      draw_path(canvas, camera, std::array<Vector3d, 2>{at - arm, at + arm}, palette::ink, 2);
    }
    const double weight = court.racket.mass * court.racket.gravity;
    if (weight > 0 && touch->push.norm() > 0) {
      const double length = 0.06 * std::sqrt(touch->push.norm() / weight);
      const Vector3d tip = at + length * touch->push.normalized();
      arrow(at, tip, palette::spring, Shaft::force);
      draw_label_at(canvas, camera, tip, {12, -8}, "push " + with_unit(touch->push.norm(), "N"),
                    palette::spring);
    }
    draw_label_at(canvas, camera, at, {14, 8}, "touch", palette::ink);
  }
  draw_distance(canvas, camera, court);
  const Vector3d ball = now.ball.position, tip = ball + 0.15 * now.ball.velocity;
  arrow(ball, tip, palette::motion, Shaft::velocity);
  draw_label_at(canvas, camera, tip, {14, -6}, with_unit(now.ball.velocity.norm(), "m/s"),
                palette::motion);
}

}  // namespace bounce
