#include "app/side_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/palette.hpp"
#include "run/rows.hpp"

namespace bounce {
namespace {

constexpr float per_second = 130;          // px on the time axis
constexpr float per_metre_per_second = 9;  // px of the velocity arrow
constexpr float ruler_x = 64;
constexpr double strobe_interval = 0.1;    // s
constexpr double peak_hold = 0.7;          // s that the largest contact force stays in sight
constexpr float fastest_throw = 8;         // m/s
constexpr float strobe_ghost_offset = 96;  // px between the ball's images and the exact ones

float column_x(const BallOnALine& ball) {
  return layout::scene.width * (ball.strobe ? 0.36f : 0.60f);
}

double height_of(const std::vector<double>& values) { return state_in<double>(values).position; }
double speed_of(const std::vector<double>& values) { return state_in<double>(values).velocity; }

void draw_ruler(Canvas& canvas, const SideCamera& camera, double lowest, double highest) {
  const Rect& area = layout::scene;
  const float x0 = ruler_x - camera.origin.x;
  const std::vector<double> major = ticks(lowest, highest, 6);
  const double step = major.size() > 1 ? major[1] - major[0] : 1;
  const auto grid = [&](double y, Colour colour) {
    const float at = camera.at(0, y).y;
    const std::array<Point, 2> line{{{ruler_x, at}, {area.right() - 8, at}}};
    canvas.line(line, colour, 1);
  };
  for (double y : ticks(lowest, highest, 30)) grid(y, palette::grid_minor);
  for (const double y : major) {
    grid(y, palette::grid_major);
    char text[32];
    std::snprintf(text, sizeof text, step < 0.1 ? "%.2f" : step < 1 ? "%.1f" : "%g", y);
    canvas.text({ruler_x - 14, camera.at(0, y).y - 8}, text, palette::ink, Align::right,
                TextSize::tick);
    const std::array<Point, 2> tick{
        {{ruler_x - 8, camera.at(0, y).y}, {ruler_x, camera.at(0, y).y}}};
    canvas.line(tick, palette::ink, 1.5f);
  }
  const std::array<Point, 2> edge{{{ruler_x, camera.at(x0, lowest).y}, {ruler_x, area.y + 34}}};
  canvas.line(edge, palette::ink, 1.5f);
  canvas.text({ruler_x + 6, area.y + 30}, "m", palette::exact, Align::left, TextSize::tick);
}

/// Height against time: the present is the ball's column.
class TimePath {
 public:
  TimePath(const SideCamera& camera, float column, double now)
      : camera_(camera), column_(column), now_(now) {}
  Point at(double t, double y) const {
    return {column_ + static_cast<float>(t - now_) * per_second, camera_.at(0, y).y};
  }
  std::vector<Point> path(const std::vector<TracePoint>& points) const {
    std::vector<Point> path;
    for (const TracePoint& point : points) path.push_back(at(point.t, height_of(point.values)));
    return path;
  }
  /// A height that is known at all times, from one moment to another, in pieces of 1/120 s.
  std::vector<Point> path(const std::function<double(double)>& height, double from,
                          double to) const {
    std::vector<Point> path;
    for (double t = to; t > from; t -= 1.0 / 120) path.push_back(at(t, height(t)));
    path.push_back(at(from, height(from)));
    return path;
  }

 private:
  const SideCamera& camera_;
  float column_;
  double now_;
};

void draw_past(Canvas& canvas, const Player& player, const TimePath& path, const BallOnALine& ball,
               const View& view) {
  constexpr std::size_t piece = 24;  // points drawn with the same paleness
  const auto& trace = player.trace();
  const double now = player.shown_time();
  const double oldest = now - (column_x(ball) - ruler_x) / per_second;
  std::vector<Point> curve, exact, floor;
  float last_label = -100;
  const auto flush = [&](double t) {
    const double age = std::clamp((now - t) / (now - oldest), 0.0, 1.0);
    canvas.line(curve, palette::motion.faded(0.75 * (1 - 0.8 * age)), 1.5f);
    if (view.ghost) draw_dashed(canvas, exact, palette::exact.faded(0.8 * (1 - age)), 1);
    curve.clear();
    exact.clear();
  };
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const TracePoint& point = trace[i];
    if (point.t < oldest || point.t > now) continue;
    curve.push_back(path.at(point.t, height_of(point.values)));
    if (ball.floor_height) floor.push_back(path.at(point.t, point.column("floor")));
    if (!point.exact.empty()) exact.push_back(path.at(point.t, height_of(point.exact)));
    if (curve.size() > piece) {
      const Point joint = curve.back(), exact_joint = exact.empty() ? joint : exact.back();
      flush(point.t);
      curve.push_back(joint);
      if (!point.exact.empty()) exact.push_back(exact_joint);
    }
    // The top of a bounce, with its height.
    if (i > 0 && speed_of(trace[i - 1].values) > 0 && speed_of(point.values) <= 0 &&
        height_of(point.values) > ball.radius) {
      const Point top = path.at(point.t, height_of(point.values));
      if (top.x < last_label + 52) continue;
      last_label = top.x;
      char text[32];
      std::snprintf(text, sizeof text, "%.3f", height_of(point.values));
      canvas.disc(top, 2.5f, palette::motion);
      draw_label(canvas, {top.x, top.y - 20}, text, palette::ink, Align::centre);
    }
  }
  if (player.shown_time() > oldest) curve.push_back(path.at(now, height_of(player.shown_values())));
  flush(now);
  canvas.line(floor, palette::ink.faded(0.4), 1.5f);
}

void draw_strobe(Canvas& canvas, const Player& player, const SideCamera& camera, float x,
                 float radius, bool ghost) {
  const auto& trace = player.trace();
  float last_label = -100;
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const TracePoint &before = trace[i - 1], &after = trace[i];
    const double n = std::max(0.0, std::ceil(before.t / strobe_interval - 1e-9));
    const double t = n * strobe_interval;
    if (t >= after.t - 1e-9 || t > player.shown_time()) continue;
    const double share = (t - before.t) / (after.t - before.t);
    const auto height = [&](const std::vector<double>& a, const std::vector<double>& b) {
      return camera.at(0, height_of(a) + share * (height_of(b) - height_of(a))).y;
    };
    const float y = height(before.values, after.values);
    canvas.disc({x, y}, radius, palette::ball.faded(0.6));
    canvas.circle({x, y}, radius, palette::ink.faded(0.35), 1);
    if (ghost && !before.exact.empty() && !after.exact.empty()) {
      const float exact_y = height(before.exact, after.exact);
      draw_dashed_circle(canvas, {x + strobe_ghost_offset, exact_y}, radius,
                         palette::exact.faded(0.55), 1);
      const std::array<Point, 2> link{
          {{x + radius, y}, {x + strobe_ghost_offset - radius, exact_y}}};
      canvas.line(link, palette::grid_major, 1);
    }
    if (std::abs(y - last_label) < 15) continue;
    last_label = y;
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", t);
    canvas.text({x - radius - 12, y - 8}, text, palette::exact, Align::right, TextSize::tick);
  }
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

/// An arrow up or down from `from`, with its name and size beside the tip: on the spring's side
/// (left) or on the damper's.
void draw_force(Canvas& canvas, Point from, double force, double weight, Colour colour,
                double share, const std::string& name, Align side) {
  const float length = force_length(force, weight);
  if (length < 1) return;
  const Point tip{from.x, from.y - std::copysign(length, static_cast<float>(force))};
  draw_arrow(canvas, from, tip, colour.faded(share));
  if (length < 14 || share < 0.4 || name.empty()) return;
  const float away = side == Align::right ? -8.0f : 8.0f;
  draw_label(canvas, {tip.x + away, tip.y - (force > 0 ? 2 : 12)},
             name + " " + with_unit(std::abs(force), "N"), palette::ink, side);
}

void draw_forces(Canvas& canvas, const Player& player, const View& view, const BallOnALine& ball,
                 Point centre, float radius, float ground) {
  const Forces<double> now =
      ball.forces(player.shown_time(), state_in<double>(player.shown_values()));
  const double weight = std::abs(now.gravity);
  draw_force(canvas, centre, now.gravity, weight, palette::gravity, 1, "", Align::left);
  if (weight > 0) {  // beside the ball, where no other arrow comes
    const Point at = ball.strobe ? Point{centre.x, centre.y + radius + 16}
                                 : Point{centre.x - radius - 8, centre.y - 8};
    draw_label(canvas, at, "weight " + with_unit(weight, "N"), palette::ink,
               ball.strobe ? Align::centre : Align::right);
  }
  if (!view.forces) return;

  // A contact is over in two frames: its largest force stays in sight for a while.
  Forces<double> peak{};
  double age = peak_hold;
  for (auto point = player.trace().rbegin(); point != player.trace().rend(); ++point) {
    if (player.shown_time() - point->t > peak_hold) break;
    if (point->t > player.shown_time()) continue;
    const Forces<double> then = ball.forces(point->t, state_in<double>(point->values));
    if (then.spring <= peak.spring) continue;
    peak = then;
    age = player.shown_time() - point->t;
  }
  const Point contact{centre.x, std::min(ground, centre.y + radius)};
  const Point left{contact.x - 10, contact.y}, right{contact.x + 10, contact.y};
  if (now.spring != 0) {
    draw_force(canvas, left, now.spring, weight, palette::spring, 1, "spring", Align::right);
    draw_force(canvas, right, now.damper, weight, palette::damper, 1, "damper", Align::left);
  } else if (peak.spring > 0) {
    const double share = 0.9 * (1 - age / peak_hold);
    draw_force(canvas, {left.x, ground}, peak.spring, weight, palette::spring, share,
               "spring, peak", Align::right);
  }
  const double speed = speed_of(player.shown_values());
  const Point foot{centre.x + radius + 40, centre.y};
  const Point tip{foot.x, foot.y - static_cast<float>(speed) * per_metre_per_second};
  draw_arrow(canvas, foot, tip, palette::motion, Shaft::velocity);
  if (std::abs(speed) > 0.5) {
    draw_label(canvas, {tip.x + 10, tip.y - 8}, with_unit(speed, "m/s"), palette::ink);
  }
}

void draw_time_axis(Canvas& canvas, const TimePath& path, double now, float y, float column) {
  for (int n = -3; n <= 2; ++n) {
    const Point at = path.at(now + n, 0);
    if (at.x < ruler_x + 10 || at.x > layout::scene.right() - 10) continue;
    const std::array<Point, 2> tick{{{at.x, y}, {at.x, y + 5}}};
    canvas.line(tick, palette::ink, 1.5f);
    char text[32];
    std::snprintf(text, sizeof text, n == 0 ? "now" : "%+d s", n);
    canvas.text({at.x, y + 10}, text, n == 0 ? palette::ink : palette::exact, Align::centre,
                TextSize::tick);
  }
  const std::array<Point, 2> line{{{column, layout::scene.y + 34}, {column, y}}};
  draw_dashed(canvas, line, palette::grid_major, 1);
}

void draw_gap(Canvas& canvas, Point ball, Point ghost, double metres) {
  if (std::abs(ball.y - ghost.y) < 3) return;
  const float x = ghost.x + 44;
  const std::array<Point, 2> bracket{{{x, ball.y}, {x, ghost.y}}};
  canvas.line(bracket, palette::ink, 1.5f);
  for (const float y : {ball.y, ghost.y}) {
    const std::array<Point, 2> foot{{{x - 5, y}, {x + 5, y}}};
    canvas.line(foot, palette::ink, 1.5f);
  }
  draw_label(canvas, {x + 10, (ball.y + ghost.y) / 2 - 9}, with_unit(metres, "m") + " apart",
             palette::ink, Align::left, TextSize::normal);
}

SideCamera side_camera(const Player& player, const BallOnALine& ball) {
  const Rect& area = layout::scene;
  double highest = ball.highest;
  for (const TracePoint& point : player.trace()) {
    while (height_of(point.values) + ball.radius > highest && highest < 1e12) highest *= 2;
  }
  const double lowest = ball.floor ? ball.lowest * highest / ball.highest : ball.lowest;
  const float top = area.y + 40, bottom = area.bottom() - 34;
  const float per_metre = (bottom - top) / static_cast<float>(highest - lowest);
  return {{column_x(ball), bottom + static_cast<float>(lowest) * per_metre}, per_metre};
}

bool is_on_ball(Point pixel, const Player& player, const BallOnALine& ball) {
  const SideCamera camera = side_camera(player, ball);
  const Point centre = camera.at(0, height_of(player.shown_values()));
  const float reach = std::max(12.0f, camera.length(ball.radius));
  return std::hypot(pixel.x - centre.x, pixel.y - centre.y) < reach;
}

}  // namespace

void draw_side_view(Canvas& canvas, const Player& player, const View& view,
                    const BallOnALine& ball) {
  const SideCamera camera = side_camera(player, ball);
  const Rect& area = layout::scene;
  const float x = column_x(ball);
  const double now = player.shown_time();
  const double y = height_of(player.shown_values());
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
  if (ball.strobe && view.trail) draw_strobe(canvas, player, camera, x, radius, view.ghost);
  if (!ball.strobe && view.trail) draw_past(canvas, player, path, ball, view);

  draw_ball(canvas, centre, radius);
  if (ball.floor) draw_overlap(canvas, centre, radius, ground);
  const std::vector<double> exact = player.simulation().exact_values(now);
  if (view.ghost && !exact.empty()) {
    const Point ghost{x + (ball.strobe ? strobe_ghost_offset : 0),
                      camera.at(0, height_of(exact)).y};
    draw_dashed_circle(canvas, ghost, radius, palette::exact, 1.5f);
    if (ball.strobe) {
      canvas.text({x, area.y + 12}, "method", palette::ink, Align::centre, TextSize::normal);
      canvas.text({ghost.x, area.y + 12}, "exact", palette::exact, Align::centre, TextSize::normal);
      draw_gap(canvas, centre, ghost, std::abs(y - height_of(exact)));
    }
  }
  draw_forces(canvas, player, view, ball, centre, radius, ground);
  canvas.pop_clip();
}

void use_side_view(Demo& demo, const std::function<BallOnALine(const Simulation&)>& look) {
  const auto ball = [look](const Player& player) { return look(player.simulation()); };
  demo.picture = [ball](const Player& player, const View& view, Canvas& canvas) {
    draw_side_view(canvas, player, view, ball(player));
  };
  demo.is_on_ball = [ball](const Player& player, const View& /*view*/, Point at) {
    return is_on_ball(at, player, ball(player));
  };
  demo.drag = [ball](Player& player, const View& /*view*/, Point at, Point velocity) {
    const SideCamera camera = side_camera(player, ball(player));
    const double height = (camera.origin.y - at.y) / camera.per_metre;
    const double speed = std::clamp(-velocity.y / camera.per_metre, -fastest_throw, fastest_throw);
    player.change([&](Simulation& simulation) { simulation.place({height, speed}); });
  };
}

}  // namespace bounce
