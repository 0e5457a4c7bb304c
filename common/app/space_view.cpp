#include "app/space_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/camera.hpp"
#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"
#include "run/rows.hpp"

namespace bounce {
namespace {

using Eigen::Vector3d;

constexpr Rect inset{layout::scene.width - 216, 12, 204, 168};
constexpr double opening = 34;         // degrees
constexpr double trail_length = 4;     // s
constexpr double mark_interval = 0.1;  // s between the dots on the trail
constexpr double peak_hold = 0.7;      // s that the largest contact force stays in sight
constexpr double arrow_time = 0.12;    // s: a velocity arrow shows the way of this time
constexpr double fastest_throw = 8;    // m/s

Vector3d position_of(const std::vector<double>& values) {
  return state_in<Vector3d>(values).position;
}
Vector3d velocity_of(const std::vector<double>& values) {
  return state_in<Vector3d>(values).velocity;
}

/// How much further away the camera must stand, so that the highest bounce fits: 1, 2, 4, ...
double zoom_out(const Player& player, const BallInSpace& ball) {
  double zoom = 1;
  for (const TracePoint& point : player.trace()) {
    const double height = ball.plane.distance(position_of(point.values));
    while (height > 1.6 * zoom && zoom < 1e12) zoom *= 2;
  }
  return zoom;
}

/// What the camera looks at. It follows a ball that leaves the room around the first place.
Vector3d target(const Player& player, const BallInSpace& ball, double zoom) {
  const Vector3d now = position_of(player.shown_values());
  Vector3d way = now - ball.look_at;
  if (ball.has_plane) way -= ball.plane.normal.dot(way) * ball.plane.normal;
  const double excess = std::max(0.0, 1 - ball.room * zoom / std::max(way.norm(), 1e-9));
  return ball.look_at + excess * way + Vector3d(0, 0.3 * (zoom - 1), 0);
}

Camera camera_for(const Player& player, const BallInSpace& ball, Rect area, bool from_above) {
  const double zoom = zoom_out(player, ball);
  const Vector3d look_at = target(player, ball, zoom);
  const double distance = ball.distance * zoom;
  if (from_above) {  // from far away, where height hardly shifts a point in the picture: a map
    const Vector3d eye = look_at + Vector3d(0, 20 * distance, 0);
    return {eye, look_at, {0, 0, -1}, area, opening / 20};
  }
  const Vector3d direction = Vector3d(-0.10, 0.30, 0.95).normalized();
  return {look_at + distance * direction, look_at, {0, 1, 0}, area, opening};
}

/// The points of the trace between two times; the present is the last one.
struct Past {
  std::vector<double> times;
  std::vector<Vector3d> points;
  std::vector<Vector3d> exact;
};

Past past(const Player& player, double from) {
  Past past;
  for (const TracePoint& point : player.trace()) {
    if (point.t < from || point.t > player.shown_time()) continue;
    past.times.push_back(point.t);
    past.points.push_back(position_of(point.values));
    if (!point.exact.empty()) past.exact.push_back(position_of(point.exact));
  }
  past.times.push_back(player.shown_time());
  past.points.push_back(position_of(player.shown_values()));
  return past;
}

std::vector<Vector3d> path(const std::vector<TracePoint>& points) {
  std::vector<Vector3d> all;
  for (const TracePoint& point : points) all.push_back(position_of(point.values));
  return all;
}

/// The trail fades with age and carries a dot every tenth of a second: even dots, even speed.
void draw_trail(Canvas& canvas, const Camera& camera, const Player& player,
                const BallInSpace& ball) {
  constexpr std::size_t piece = 24;  // points drawn with the same paleness
  const double now = player.shown_time();
  const Past trail = past(player, now - trail_length);
  const auto paleness = [&](double t) { return 1 - 0.85 * (now - t) / trail_length; };
  for (std::size_t i = 0; i + 1 < trail.points.size(); i += piece) {
    const std::size_t count = std::min(piece + 1, trail.points.size() - i);
    const std::span<const Vector3d> part(&trail.points[i], count);
    const double share = paleness(trail.times[i]);
    if (ball.has_plane && ball.plane.normal.y() > 0.05) {
      std::vector<Vector3d> shadow;
      for (const Vector3d& point : part) shadow.push_back(below(ball.plane, point));
      draw_path(canvas, camera, shadow, palette::ink.faded(0.22 * share), 1.5f);
    }
    draw_path(canvas, camera, part, palette::motion.faded(0.8 * share), 1.5f);
  }
  for (std::size_t i = 1; i < trail.points.size(); ++i) {
    const double t = mark_interval * std::floor(trail.times[i] / mark_interval + 1e-9);
    if (t <= trail.times[i - 1] + 1e-9 || t > trail.times[i] + 1e-9) continue;
    const double share = (t - trail.times[i - 1]) / (trail.times[i] - trail.times[i - 1]);
    const Vector3d at = trail.points[i - 1] + share * (trail.points[i] - trail.points[i - 1]);
    if (!camera.sees(at)) continue;
    canvas.disc(camera.at(at), 2.5f, palette::motion.faded(paleness(t)));
  }
}

/// Where and when the ball touched the plane.
struct Landing {
  double t;
  Vector3d foot;
};

std::vector<Landing> landings(const Player& player, const BallInSpace& ball) {
  std::vector<Landing> all;
  const auto gap = [&](const TracePoint& point) {
    return ball.plane.distance(position_of(point.values)) - ball.radius;
  };
  const auto speed = [&](const TracePoint& point) {
    return ball.plane.normal.dot(velocity_of(point.values));
  };
  // A stiff contact can begin and end between two points of the trace. What always shows is that
  // the ball comes back; the touch is then found from the last point before it.
  const auto& trace = player.trace();
  const TracePoint* last_in_flight = nullptr;
  for (const TracePoint& point : trace) {
    if (point.t > player.shown_time()) break;
    if (last_in_flight != nullptr && speed(point) > 0) {
      const double wait = gap(*last_in_flight) / -speed(*last_in_flight);
      const Vector3d place =
          position_of(last_in_flight->values) + wait * velocity_of(last_in_flight->values);
      all.push_back({last_in_flight->t + wait, ball.plane.foot(place)});
      last_in_flight = nullptr;
    }
    if (gap(point) > 0 && speed(point) < 0) last_in_flight = &point;
  }
  return all;
}

void draw_landings(Canvas& canvas, const Camera& camera, const Player& player,
                   const BallInSpace& ball) {
  const std::vector<Landing> marks = landings(player, ball);
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
    const Vector3d middle = (last + foot) / 2 + 0.14 * across;
    if (!camera.sees(middle)) continue;
    char text[48];
    std::snprintf(text, sizeof text, "%.2f m, %.3f s", hop, marks[i].t - marks[i - 1].t);
    draw_label(canvas, {camera.at(middle).x, camera.at(middle).y + 6}, text, palette::ink,
               Align::centre);
  }
}

/// An arrow from `foot` (shifted sideways in the picture) along a force.
void draw_force(Canvas& canvas, const Camera& camera, const Vector3d& foot, float shift,
                const Vector3d& force, double weight, Colour colour, double share,
                const char* name) {
  const float pixels = force_length(force.norm(), weight);
  if (pixels < 1) return;
  const Vector3d end =
      foot + force.normalized() * static_cast<double>(pixels / camera.per_metre(foot));
  if (!camera.sees(foot) || camera.depth(end) < Camera::nearest) return;
  const Point a = camera.at(foot), b = camera.at(end);
  const Point from{a.x + shift, a.y}, to{b.x + shift, b.y};
  draw_arrow(canvas, from, to, colour.faded(share));
  if (*name == '\0' || std::hypot(to.x - from.x, to.y - from.y) < 14 || share < 0.4) return;
  const std::string words = std::string(name) + " " + with_unit(force.norm(), "N");
  // The damper's on its right; the others on their left, the weight's clear of the ball.
  const float gap = shift > 0 ? 8.0f : shift < 0 ? -8.0f : -26.0f;
  draw_label(canvas, {to.x + gap, to.y - 6}, words, palette::ink,
             shift > 0 ? Align::left : Align::right);
}

void draw_velocity(Canvas& canvas, const Camera& camera, const State<Vector3d>& state) {
  const Vector3d tip = state.position + arrow_time * state.velocity;
  if (!camera.sees(state.position) || camera.depth(tip) < Camera::nearest) return;
  const Point at = camera.at(tip);
  draw_arrow(canvas, camera.at(state.position), at, palette::motion, Shaft::velocity);
  if (state.velocity.norm() < 0.3) return;
  draw_label(canvas, {at.x + 14, at.y - 8}, with_unit(state.velocity.norm(), "m/s"), palette::ink);
}

void draw_forces(Canvas& canvas, const Camera& camera, const Player& player, const View& view,
                 const BallInSpace& ball) {
  const State<Vector3d> state = state_in<Vector3d>(player.shown_values());
  const Forces<Vector3d> now = ball.forces(player.shown_time(), state);
  const double weight = now.gravity.norm();
  if (view.forces) draw_velocity(canvas, camera, state);
  draw_force(canvas, camera, state.position, 0, now.gravity, weight, palette::gravity, 1,
             ball.landings ? "" : "weight");  // there its words would cover the marks
  if (!view.forces) return;

  // A contact is over in two frames: its largest force stays in sight where it was.
  Forces<Vector3d> peak{};
  Vector3d place = state.position;
  double age = peak_hold;
  for (auto point = player.trace().rbegin(); point != player.trace().rend(); ++point) {
    if (player.shown_time() - point->t > peak_hold) break;
    if (point->t > player.shown_time()) continue;
    const Forces<Vector3d> then = ball.forces(point->t, state_in<Vector3d>(point->values));
    if (then.spring.norm() <= peak.spring.norm()) continue;
    peak = then;
    place = position_of(point->values);
    age = player.shown_time() - point->t;
  }
  if (now.spring.norm() > 0) {
    const Vector3d foot = ball.plane.foot(state.position);
    draw_force(canvas, camera, foot, -10, now.spring, weight, palette::spring, 1, "spring");
    draw_force(canvas, camera, foot, 10, now.damper, weight, palette::damper, 1, "damper");
  } else if (peak.spring.norm() > 0) {
    draw_force(canvas, camera, ball.plane.foot(place), -10, peak.spring, weight, palette::spring,
               0.9 * (1 - age / peak_hold), "spring, peak");
  }
}

void draw_scene(Canvas& canvas, const Player& player, const View& view, const BallInSpace& ball,
                Rect area, bool from_above, bool is_main) {
  const Camera camera = camera_for(player, ball, area, from_above);
  const Vector3d now = position_of(player.shown_values());
  const double zoom = zoom_out(player, ball);
  const double square = ball.distance * zoom < 6 ? 0.5 : 1.0 * zoom;  // m
  canvas.push_clip(area);
  if (ball.has_plane) {
    const Vector3d centre = target(player, ball, zoom);
    draw_plane_grid(canvas, camera, ball.plane, centre, square, 10 * square);
    draw_shadow(canvas, camera, ball.plane, now, ball.radius);
  }
  if (ball.landings && ball.has_plane && is_main) draw_landings(canvas, camera, player, ball);
  if (!view.earlier.empty()) {
    draw_dashed_path(canvas, camera, path(view.earlier), palette::exact.faded(0.6), 1.5f);
  }
  if (!view.future.empty()) {
    draw_path(canvas, camera, path(view.future), palette::motion.faded(0.35), 2);
  }
  if (view.trail) draw_trail(canvas, camera, player, ball);
  if (is_main && ball.has_plane && ball.plane.normal.y() > 0.05) {
    const std::array<Vector3d, 2> plumb{below(ball.plane, now), now};
    draw_dashed_path(canvas, camera, plumb, palette::exact.faded(0.7), 1);
  }
  draw_ball_in_space(canvas, camera, now, ball.radius);
  const std::vector<double> exact = player.simulation().exact_values(player.shown_time());
  if (view.ghost && is_main && !exact.empty()) {
    const Vector3d ghost = position_of(exact);
    if (camera.sees(ghost)) {
      const float size = static_cast<float>(ball.radius) * camera.per_metre(ghost);
      draw_dashed_circle(canvas, camera.at(ghost), std::max(3.0f, size), palette::exact, 1.5f);
    }
  }
  if (is_main) {
    draw_forces(canvas, camera, player, view, ball);
    draw_axes(canvas, camera, {44, area.bottom() - 66});
    const std::string squares = "squares " + to_rounded_text(square) + " m   ";
    canvas.text({96, area.bottom() - 30},
                (ball.has_plane ? squares : "") + "dots 0.1 s   force arrows: length ~ sqrt(force)",
                palette::exact, Align::left, TextSize::tick);
  }
  canvas.pop_clip();
}

}  // namespace

void draw_space_view(Canvas& canvas, const Player& player, const View& view,
                     const BallInSpace& ball) {
  draw_scene(canvas, player, view, ball, layout::scene, view.from_above, true);
  draw_rect(canvas, inset, palette::paper);
  draw_scene(canvas, player, view, ball, inset, !view.from_above, false);
  draw_frame(canvas, inset, palette::grid_major, 1);
  canvas.text({inset.x + 8, inset.y + 5}, view.from_above ? "from the side (T)" : "from above (T)",
              palette::ink, Align::left, TextSize::tick);
}

void use_space_view(Demo& demo, const std::function<BallInSpace(const Simulation&)>& look) {
  const auto ball = [look](const Player& player) { return look(player.simulation()); };
  demo.in_space = true;
  demo.picture = [ball](const Player& player, const View& view, Canvas& canvas) {
    draw_space_view(canvas, player, view, ball(player));
  };
  const auto camera = [ball](const Player& player, const View& view) {
    return camera_for(player, ball(player), layout::scene, view.from_above);
  };
  demo.is_on_ball = [ball, camera](const Player& player, const View& view, Point at) {
    const Camera eye = camera(player, view);
    const Vector3d now = position_of(player.shown_values());
    if (!eye.sees(now)) return false;
    const Point centre = eye.at(now);
    const float reach =
        std::max(12.0f, static_cast<float>(ball(player).radius) * eye.per_metre(now));
    return std::hypot(at.x - centre.x, at.y - centre.y) < reach;
  };
  demo.drag = [camera](Player& player, const View& view, Point at, Point velocity) {
    const Camera eye = camera(player, view);
    const Vector3d now = position_of(player.shown_values());
    const Vector3d place = eye.under(at, now);
    Vector3d speed = eye.across(velocity, now);
    if (speed.norm() > fastest_throw) speed *= fastest_throw / speed.norm();
    player.change([&](Simulation& simulation) {
      simulation.place({place.x(), place.y(), place.z(), speed.x(), speed.y(), speed.z()});
    });
  };
}

}  // namespace bounce
