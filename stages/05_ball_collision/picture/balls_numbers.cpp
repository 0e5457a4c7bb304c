#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "05_ball_collision/picture/balls_marks.hpp"
#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

void draw_speeds(Canvas& canvas, const Camera& camera, const BallsRun& simulation,
                 const std::vector<double>& rows, std::size_t balls) {
  for (std::size_t i = 0; i < balls && balls <= 7; ++i) {
    const double radius = simulation.scene().radius[static_cast<Eigen::Index>(i)];
    const Vector3d foot = position(rows, i) - Vector3d(0, radius, 0);
    if (!camera.sees(foot)) continue;
    const bool row = simulation.world().choice.scene == BallScene::cradle;
    const Vector3d v = velocity(rows, i);
    double speed = row ? v.x() : v.norm();
    if (std::abs(speed) < 5e-4) speed = 0;  // and not -0.000
    char text[64];
    std::snprintf(text, sizeof text, row ? "%+.3f m/s" : "%.2f m/s", speed);
    const Point at = camera.at(foot);
    if (simulation.world().choice.scene == BallScene::tower) {
      draw_label(canvas, {at.x + 34, at.y - 20}, text, palette::ink);
    } else {
      draw_label(canvas, {at.x, at.y + 12}, text, palette::ink, Align::centre);
    }
  }
}

void draw_tower_heights(Canvas& canvas, const Camera& camera, const Playback& playback) {
  const BallsRun& simulation = balls_of(playback);
  // Heights of the small ball's centre above where it is when both lie on the floor, in falls.
  const double lying = 2 * simulation.scene().radius[0] + simulation.scene().radius[1];
  constexpr double fall = 0.8;
  const auto mark = [&](double height, const std::string& words, Colour colour) {
    const std::array<Vector3d, 2> line{{{-0.6, height, 0}, {0.6, height, 0}}};
    draw_dashed_path(canvas, camera, line, colour, 1.5f);
    const Point end = camera.at(line[1]);
    draw_label(canvas, {end.x + 8, end.y - 9}, words, palette::ink, Align::left, TextSize::normal);
  };
  mark(lying + fall, "1 x the fall", palette::exact);
  mark(lying + 6.95 * fall, "6.95 x: two collisions, one after the other", palette::exact);
  double top = 0;
  bool thrown = false, over = false;
  for (const TracePoint& point : playback.trace()) {
    if (point.values.size() < 14 || point.t > playback.shown_time()) continue;
    const double up = velocity(point.values, 1).y();
    thrown = thrown || up > 1;
    over = over || (thrown && up < -0.01);
    if (thrown && !over) top = std::max(top, position(point.values, 1).y());
  }
  if (top < lying) return;
  char text[64];
  std::snprintf(text, sizeof text, "%.2f x", (top - lying) / fall);
  const Vector3d at(-0.7, top, 0);
  if (!camera.sees(at)) return;
  const std::array<Vector3d, 2> line{{{-0.6, top, 0}, {0.2, top, 0}}};
  draw_path(canvas, camera, line, palette::motion, 2);
  draw_label(canvas, {camera.at(at).x, camera.at(at).y - 9}, text, palette::ink, Align::right,
             TextSize::title);
}

}  // namespace

void draw_numbers(Canvas& canvas, const Camera& camera, const Playback& playback,
                  const std::vector<double>& rows, std::size_t balls) {
  const BallsRun& simulation = balls_of(playback);
  if (simulation.world().own_balls) return;
  const BallScene scene = simulation.world().choice.scene;
  if (scene == BallScene::cradle || balls == 2) {
    draw_speeds(canvas, camera, simulation, rows, balls);
  }
  if (scene == BallScene::tower) draw_tower_heights(canvas, camera, playback);
}

}  // namespace bounce
