#include "app/side_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/side_forces.hpp"
#include "app/side_past.hpp"

namespace bounce {
namespace {

void draw_ruler(Canvas& canvas, const SideCamera& camera, double lowest, double highest) {
  const Rect& area = layout::scene;
  const float x0 = ruler_x - camera.origin.x;
  const std::vector<double> major = ticks(lowest, highest, 6);
  const double step = major.size() > 1 ? major[1] - major[0] : 1;
  const auto grid = [&](double y, Colour colour) {
    const float at = camera.at(0, y).y;
    draw_line(canvas, {ruler_x, at}, {area.right() - 8, at}, colour, 1);
  };
  for (double y : ticks(lowest, highest, 30)) grid(y, palette::grid_minor);
  for (const double y : major) {
    grid(y, palette::grid_major);
    char text[32];
    std::snprintf(text, sizeof text, step < 0.1 ? "%.2f" : step < 1 ? "%.1f" : "%g", y);
    canvas.text({ruler_x - 14, camera.at(0, y).y - 8}, text, palette::ink, Align::right,
                TextSize::tick);
    draw_line(canvas, {ruler_x - 8, camera.at(0, y).y}, {ruler_x, camera.at(0, y).y}, palette::ink,
              1.5f);
  }
  draw_line(canvas, {ruler_x, camera.at(x0, lowest).y}, {ruler_x, area.y + 34}, palette::ink, 1.5f);
  canvas.text({ruler_x + 6, area.y + 30}, "m", palette::exact, Align::left, TextSize::tick);
}

/// The part of the ball below the ground: what the spring answers to.
void draw_overlap(Canvas& canvas, Point centre, float radius, float ground) {
  if (centre.y + radius <= ground + 0.5f) return;
  const double half = std::acos(std::clamp((ground - centre.y) / radius, -1.0f, 1.0f));
  std::vector<Point> segment;
  for (int i = 0; i <= 32; ++i) {
    const double angle = half * (i / 16.0 - 1);  // from straight down
    segment.push_back({centre.x + radius * static_cast<float>(std::sin(angle)),
                       centre.y + radius * static_cast<float>(std::cos(angle))});
  }
  canvas.fill(segment, palette::spring.faded(0.35));
  canvas.line(segment, palette::ink, 1.5f);
}

void draw_gap(Canvas& canvas, Point ball, Point ghost, double metres) {
  if (std::abs(ball.y - ghost.y) < 3) return;
  const float x = ghost.x + 44;
  draw_line(canvas, {x, ball.y}, {x, ghost.y}, palette::ink, 1.5f);
  for (const float y : {ball.y, ghost.y}) {
    draw_line(canvas, {x - 5, y}, {x + 5, y}, palette::ink, 1.5f);
  }
  draw_label(canvas, {x + 10, (ball.y + ghost.y) / 2 - 9}, with_unit(metres, "m") + " apart",
             palette::ink, Align::left, TextSize::normal);
}

SideCamera side_camera(const Playback& playback, const BallOnALine& ball) {
  const Rect& area = layout::scene;
  double highest = ball.highest;
  for (const TracePoint& point : playback.trace()) {
    while (height_of(point.values) + ball.radius > highest && highest < 1e12) highest *= 2;
  }
  const double lowest = ball.floor ? ball.lowest * highest / ball.highest : ball.lowest;
  const float top = area.y + 40, bottom = area.bottom() - 34;
  const float per_metre = (bottom - top) / static_cast<float>(highest - lowest);
  return {{column_x(ball), bottom + static_cast<float>(lowest) * per_metre}, per_metre};
}

bool is_on_ball(Point pixel, const Playback& playback, const BallOnALine& ball) {
  const SideCamera camera = side_camera(playback, ball);
  const Point centre = camera.at(0, height_of(playback.shown_values()));
  const float reach = std::max(12.0f, camera.length(ball.radius));
  return std::hypot(pixel.x - centre.x, pixel.y - centre.y) < reach;
}

void draw_side_view(Canvas& canvas, const Playback& playback, const View& view,
                    const BallOnALine& ball) {
  const SideCamera camera = side_camera(playback, ball);
  const Rect& area = layout::scene;
  const float x = column_x(ball);
  const double now = playback.shown_time();
  const double y = height_of(playback.shown_values());
  const float ground = camera.at(0, ball.floor_height ? ball.floor_height(now) : 0).y;
  const float radius = std::max(5.0f, camera.length(ball.radius));
  const Point centre = camera.at(0, y);
  const double bottom = -(area.bottom() - 34 - camera.origin.y) / camera.per_metre;
  const double top = (camera.origin.y - area.y - 40) / camera.per_metre;

  canvas.push_clip(area);
  draw_ruler(canvas, camera, bottom, top);
  const TimePath path(camera, x, now);
  if (!view.earlier.empty() && !ball.strobe) {
    draw_dashed(canvas, path.path(view.earlier), palette::exact.faded(0.6), 1.5f);
  }
  if (!view.future.empty() && !ball.strobe) {
    canvas.line(path.path(view.future), palette::motion.faded(0.35), 2);
  }
  if (ball.floor_height) {  // a plate under the ball, with its past to the left and time below
    draw_ground(canvas, x - 2 * radius - 40, x + 2 * radius + 40, ground);
    if (!view.future.empty()) {
      canvas.line(path.path(ball.floor_height, now, view.future.back().t), palette::ink.faded(0.2),
                  1.5f);
    }
    draw_time_axis(canvas, path, now, area.bottom() - 30, x);
  } else {
    if (ball.floor) draw_ground(canvas, ruler_x, area.right() - 8, ground);
    if (!ball.strobe) draw_time_axis(canvas, path, now, ground + 12, x);
  }
  if (ball.strobe && view.trail) draw_strobe(canvas, playback, camera, x, radius, view.ghost);
  if (!ball.strobe && view.trail) draw_past(canvas, playback, path, ball, view);

  draw_ball(canvas, centre, radius);
  if (ball.floor) draw_overlap(canvas, centre, radius, ground);
  const std::vector<double> exact = playback.simulation().exact_values(now);
  if (view.ghost && !exact.empty()) {
    const Point ghost{x + (ball.strobe ? strobe_ghost_offset : 0),
                      camera.at(0, height_of(exact)).y};
    draw_dashed_circle(canvas, ghost, radius, palette::exact, 1.5f);
    if (ball.strobe) {
      canvas.text({x, area.y + 12}, "method", palette::ink, Align::centre, TextSize::normal);
      canvas.text({ghost.x, area.y + 12}, std::string(playback.simulation().traits().truth),
                  palette::exact, Align::centre, TextSize::normal);
      draw_gap(canvas, centre, ghost, std::abs(y - height_of(exact)));
    }
  }
  draw_forces(canvas, playback, view, ball, centre, radius, ground);
  canvas.pop_clip();
}

}  // namespace

void use_side_view(Demo& demo, const std::function<BallOnALine(const Simulation&)>& look) {
  const auto ball = [look](const Playback& playback) { return look(playback.simulation()); };
  demo.picture = [ball](const Playback& playback, const View& view, Canvas& canvas) {
    draw_side_view(canvas, playback, view, ball(playback));
  };
  demo.is_on_ball = [ball](const Playback& playback, const View& /*view*/, Point at) {
    return is_on_ball(at, playback, ball(playback));
  };
  demo.drag = [ball](Playback& playback, const View& /*view*/, Point at, Point velocity) {
    const SideCamera camera = side_camera(playback, ball(playback));
    const double height = (camera.origin.y - at.y) / camera.per_metre;
    const double speed = static_cast<double>(-velocity.y / camera.per_metre);
    const double thrown = std::clamp(speed, -fastest_throw, fastest_throw);
    playback.change([&](Simulation& simulation) { simulation.place({height, thrown}); });
  };
}

}  // namespace bounce
