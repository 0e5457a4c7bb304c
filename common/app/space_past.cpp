#include "app/space_past.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double trail_length = 4;     // s
constexpr double mark_interval = 0.1;  // s between the dots on the trail

/// Where and when the ball touched the plane.
struct Landing {
  double t;
  Vector3d foot;
};

std::vector<Landing> landings(const Playback& playback, const BallInSpace& ball) {
  std::vector<Landing> all;
  const auto gap = [&](const TracePoint& point) {
    return ball.plane.distance(position_in(point.values)) - ball.radius;
  };
  const auto speed = [&](const TracePoint& point) {
    return ball.plane.normal.dot(state_in<Vector3d>(point.values).velocity);
  };
  // A stiff contact can begin and end between two points of the trace. What always shows is that
  // the ball comes back; the touch is then found from the last point before it.
  const auto& trace = playback.trace();
  const TracePoint* last_in_flight = nullptr;
  for (const TracePoint& point : trace) {
    if (point.t > playback.shown_time()) break;
    if (last_in_flight != nullptr && speed(point) > 0) {
      const double wait = gap(*last_in_flight) / -speed(*last_in_flight);
      const Vector3d place = position_in(last_in_flight->values) +
                             wait * state_in<Vector3d>(last_in_flight->values).velocity;
      all.push_back({last_in_flight->t + wait, ball.plane.foot(place)});
      last_in_flight = nullptr;
    }
    if (gap(point) > 0 && speed(point) < 0) last_in_flight = &point;
  }
  return all;
}

}  // namespace

void draw_trail(Canvas& canvas, const Camera& camera, const Playback& playback,
                const BallInSpace& ball) {
  constexpr std::size_t piece = 24;  // points drawn with the same paleness
  const double now = playback.shown_time();
  std::vector<double> times;
  std::vector<Vector3d> points;
  for (const TracePoint& point : playback.trace()) {
    if (point.t < now - trail_length || point.t > now) continue;
    times.push_back(point.t);
    points.push_back(position_in(point.values));
  }
  times.push_back(now);
  points.push_back(position_in(playback.shown_values()));
  const auto paleness = [&](double t) { return 1 - 0.85 * (now - t) / trail_length; };
  for (std::size_t i = 0; i + 1 < points.size(); i += piece) {
    const std::size_t count = std::min(piece + 1, points.size() - i);
    const std::span<const Vector3d> part(&points[i], count);
    const double share = paleness(times[i]);
    if (ball.has_plane && ball.plane.normal.y() > 0.05) {
      std::vector<Vector3d> shadow;
      for (const Vector3d& point : part) shadow.push_back(below(ball.plane, point));
      draw_path(canvas, camera, shadow, palette::ink.faded(0.22 * share), 1.5f);
    }
    draw_path(canvas, camera, part, palette::motion.faded(0.8 * share), 1.5f);
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double t = mark_interval * std::floor(times[i] / mark_interval + 1e-9);
    if (t <= times[i - 1] + 1e-9 || t > times[i] + 1e-9) continue;
    const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
    const Vector3d at = points[i - 1] + share * (points[i] - points[i - 1]);
    if (!camera.sees(at)) continue;
    canvas.disc(camera.at(at), 2.5f, palette::motion.faded(paleness(t)));
  }
}

void draw_landings(Canvas& canvas, const Camera& camera, const Playback& playback,
                   const BallInSpace& ball) {
  const std::vector<Landing> marks = landings(playback, ball);
  const Vector3d across = axes_of(ball.plane).across;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Vector3d& foot = marks[i].foot;
    const std::array<Vector3d, 2> mark{foot - 0.16 * across, foot + 0.16 * across};
    draw_path(canvas, camera, mark, palette::ink, 2);
    if (i == 0) continue;
    const Vector3d& last = marks[i - 1].foot;
    const double hop = (foot - last).norm();
    if (hop < 0.08) continue;  // no room for words
    const std::array<Vector3d, 2> ruler{last + 0.12 * across, foot + 0.12 * across};
    draw_path(canvas, camera, ruler, palette::ink.faded(0.6), 1);
    char text[48];
    std::snprintf(text, sizeof text, "%.2f m, %.3f s", hop, marks[i].t - marks[i - 1].t);
    draw_label_at(canvas, camera, (last + foot) / 2 + 0.14 * across, {0, 6}, text, palette::ink,
                  Align::centre);
  }
}

}  // namespace bounce
