#include "app/space_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"
#include "app/space_forces.hpp"
#include "app/space_past.hpp"

namespace bounce {
namespace {

using Eigen::Vector3d;

constexpr Rect inset{layout::scene.width - 216, 12, 204, 168};

/// How much further away the camera must stand, so that the highest bounce fits: 1, 2, 4, ...
double zoom_out(const Playback& playback, const BallInSpace& ball) {
  double zoom = 1;
  for (const TracePoint& point : playback.trace()) {
    const double height = ball.plane.distance(position_in(point.values));
    while (height > 1.6 * zoom && zoom < 1e12) zoom *= 2;
  }
  return zoom;
}

/// What the camera looks at. It follows a ball that leaves the room around the first place.
Vector3d target(const Playback& playback, const BallInSpace& ball, double zoom) {
  const Vector3d now = position_in(playback.shown_values());
  Vector3d way = now - ball.look_at;
  if (ball.has_plane) way -= ball.plane.normal.dot(way) * ball.plane.normal;
  const double excess = std::max(0.0, 1 - ball.room * zoom / std::max(way.norm(), 1e-9));
  return ball.look_at + excess * way + Vector3d(0, 0.3 * (zoom - 1), 0);
}

std::vector<Vector3d> path(const std::vector<TracePoint>& points) {
  std::vector<Vector3d> all;
  for (const TracePoint& point : points) all.push_back(position_in(point.values));
  return all;
}

void draw_scene(Canvas& canvas, const Playback& playback, const View& view, const BallInSpace& ball,
                Rect area, bool from_above, bool is_main) {
  const Camera camera = camera_for(playback, ball, area, from_above);
  const Vector3d now = position_in(playback.shown_values());
  const double zoom = zoom_out(playback, ball);
  const double square = ball.distance * zoom < 6 ? 0.5 : 1.0 * zoom;  // m
  canvas.push_clip(area);
  if (ball.has_plane) {
    const Vector3d centre = target(playback, ball, zoom);
    draw_plane_grid(canvas, camera, ball.plane, centre, square, 10 * square);
    draw_shadow(canvas, camera, ball.plane, now, ball.radius);
  }
  if (ball.landings && ball.has_plane && is_main) draw_landings(canvas, camera, playback, ball);
  if (!view.earlier.empty()) {
    draw_dashed_path(canvas, camera, path(view.earlier), palette::exact.faded(0.6), 1.5f);
  }
  if (!view.future.empty()) {
    draw_path(canvas, camera, path(view.future), palette::motion.faded(0.35), 2);
  }
  if (view.trail) draw_trail(canvas, camera, playback, ball);
  if (is_main && ball.has_plane && ball.plane.normal.y() > 0.05) {
    draw_dashed_path(canvas, camera, std::array{below(ball.plane, now), now},
                     palette::exact.faded(0.7), 1);
  }
  draw_ball_in_space(canvas, camera, now, ball.radius);
  const std::vector<double> exact = playback.simulation().exact_values(playback.shown_time());
  if (view.ghost && is_main && !exact.empty()) {
    const Vector3d ghost = position_in(exact);
    if (camera.sees(ghost)) {
      const float size = static_cast<float>(ball.radius) * camera.per_metre(ghost);
      draw_dashed_circle(canvas, camera.at(ghost), std::max(3.0f, size), palette::exact, 1.5f);
    }
  }
  if (is_main) {
    draw_forces(canvas, camera, playback, view, ball);
    draw_axes(canvas, camera, {44, area.bottom() - 66});
    const std::string squares = "squares " + to_rounded_text(square) + " m   ";
    canvas.text({96, area.bottom() - 30},
                (ball.has_plane ? squares : "") + "dots 0.1 s   force arrows: length ~ sqrt(force)",
                palette::exact, Align::left, TextSize::tick);
  }
  canvas.pop_clip();
}

void draw_space_view(Canvas& canvas, const Playback& playback, const View& view,
                     const BallInSpace& ball) {
  draw_scene(canvas, playback, view, ball, layout::scene, view.from_above, true);
  draw_rect(canvas, inset, palette::paper);
  draw_scene(canvas, playback, view, ball, inset, !view.from_above, false);
  draw_frame(canvas, inset, palette::grid_major, 1);
  canvas.text({inset.x + 8, inset.y + 5}, view.from_above ? "from the side (T)" : "from above (T)",
              palette::ink, Align::left, TextSize::tick);
}

}  // namespace

Camera camera_for(const Playback& playback, const BallInSpace& ball, Rect area, bool from_above) {
  const double zoom = zoom_out(playback, ball);
  return camera_before(target(playback, ball, zoom), ball.distance * zoom, 0.30, area, from_above);
}

void use_space_view(Demo& demo, const std::function<BallInSpace(const Simulation&)>& look) {
  const auto ball = [look](const Playback& playback) { return look(playback.simulation()); };
  demo.in_space = true;
  demo.picture = [ball](const Playback& playback, const View& view, Canvas& canvas) {
    draw_space_view(canvas, playback, view, ball(playback));
  };
  const auto camera = [ball](const Playback& playback, const View& view) {
    return camera_for(playback, ball(playback), layout::scene, view.from_above);
  };
  demo.is_on_ball = [ball, camera](const Playback& playback, const View& view, Point at) {
    const Camera eye = camera(playback, view);
    const Vector3d now = position_in(playback.shown_values());
    if (!eye.sees(now)) return false;
    const Point centre = eye.at(now);
    const float reach =
        std::max(12.0f, static_cast<float>(ball(playback).radius) * eye.per_metre(now));
    return std::hypot(at.x - centre.x, at.y - centre.y) < reach;
  };
  demo.drag = [camera](Playback& playback, const View& view, Point at, Point velocity) {
    const Camera eye = camera(playback, view);
    const Vector3d now = position_in(playback.shown_values());
    const Vector3d place = eye.under(at, now);
    Vector3d speed = eye.across(velocity, now);
    if (speed.norm() > fastest_throw) speed *= fastest_throw / speed.norm();
    playback.change([&](Simulation& simulation) {
      simulation.place({place.x(), place.y(), place.z(), speed.x(), speed.y(), speed.z()});
    });
  };
}

}  // namespace bounce
