#include "app/side_past.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/palette.hpp"

namespace bounce {
namespace {

constexpr double strobe_interval = 0.1;  // s

double speed_of(const std::vector<double>& values) { return state_in<double>(values).velocity; }

}  // namespace

void draw_past(Canvas& canvas, const Playback& playback, const TimePath& path,
               const BallOnALine& ball, const View& view) {
  constexpr std::size_t piece = 24;  // points drawn with the same paleness
  const auto& trace = playback.trace();
  const double now = playback.shown_time();
  const double oldest = now - (column_x(ball) - ruler_x) / TimePath::pixels_per_second;
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
  if (playback.shown_time() > oldest)
    curve.push_back(path.at(now, height_of(playback.shown_values())));
  flush(now);
  canvas.line(floor, palette::ink.faded(0.4), 1.5f);
}

void draw_strobe(Canvas& canvas, const Playback& playback, const SideCamera& camera, float x,
                 float radius, bool ghost) {
  const auto& trace = playback.trace();
  float last_label = -100;
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const TracePoint &before = trace[i - 1], &after = trace[i];
    const double n = std::max(0.0, std::ceil(before.t / strobe_interval - 1e-9));
    const double t = n * strobe_interval;
    if (t >= after.t - 1e-9 || t > playback.shown_time()) continue;
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
      draw_line(canvas, {x + radius, y}, {x + strobe_ghost_offset - radius, exact_y},
                palette::grid_major, 1);
    }
    if (std::abs(y - last_label) < 15) continue;
    last_label = y;
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", t);
    canvas.text({x - radius - 12, y - 8}, text, palette::exact, Align::right, TextSize::tick);
  }
}

void draw_time_axis(Canvas& canvas, const TimePath& path, double now, float y, float column) {
  for (int n = -3; n <= 2; ++n) {
    const Point at = path.at(now + n, 0);
    if (at.x < ruler_x + 10 || at.x > layout::scene.right() - 10) continue;
    draw_line(canvas, {at.x, y}, {at.x, y + 5}, palette::ink, 1.5f);
    char text[32];
    std::snprintf(text, sizeof text, n == 0 ? "now" : "%+d s", n);
    canvas.text({at.x, y + 10}, text, n == 0 ? palette::ink : palette::exact, Align::centre,
                TextSize::tick);
  }
  draw_dashed(canvas, std::array{Point{column, layout::scene.y + 34}, Point{column, y}},
              palette::grid_major, 1);
}

}  // namespace bounce
