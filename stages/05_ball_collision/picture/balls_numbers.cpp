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
                 const Balls& balls) {
  const bool row = simulation.world().choice.scene == BallScene::cradle;
  const bool tower = simulation.world().choice.scene == BallScene::tower;
  for (Eigen::Index i = 0; i < balls.position.cols(); ++i) {
    const auto [position, v, radius] = simulation.scene().ball(balls, i);
    double speed = row ? v.x() : v.norm();
    if (std::abs(speed) < 5e-4) speed = 0;  // and not -0.000
    char text[64];
    std::snprintf(text, sizeof text, row ? "%+.3f m/s" : "%.2f m/s", speed);
    draw_label_at(canvas, camera, position - Vector3d(0, radius, 0),
                  tower ? Point{34, -20} : Point{0, 12}, text, palette::ink,
                  tower ? Align::left : Align::centre);
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
    draw_label_at(canvas, camera, line[1], {8, -9}, words, palette::ink, Align::left,
                  TextSize::normal);
  };
  mark(lying + fall, "1 x the fall", palette::exact);
  mark(lying + 6.95 * fall, "6.95 x: two collisions, one after the other", palette::exact);
  double top = 0;
  bool thrown = false, over = false;
  for (const TracePoint& point : playback.trace()) {
    const Balls balls = balls_in(point.values);
    if (balls.position.cols() < 2 || point.t > playback.shown_time()) continue;
    const double up = balls.velocity(1, 1);  // of the small ball
    thrown = thrown || up > 1;
    over = over || (thrown && up < -0.01);
    if (thrown && !over) top = std::max(top, balls.position(1, 1));
  }
  if (top < lying) return;
  char text[64];
  std::snprintf(text, sizeof text, "%.2f x", (top - lying) / fall);
  draw_path(canvas, camera, std::array<Vector3d, 2>{{{-0.6, top, 0}, {0.2, top, 0}}},
            palette::motion, 2);
  draw_label_at(canvas, camera, {-0.7, top, 0}, {0, -9}, text, palette::ink, Align::right,
                TextSize::title);
}

}  // namespace

void draw_numbers(Canvas& canvas, const Camera& camera, const Playback& playback,
                  const Balls& balls) {
  const BallsRun& simulation = balls_of(playback);
  if (simulation.world().own_balls) return;
  const BallScene scene = simulation.world().choice.scene;
  const Eigen::Index count = balls.position.cols();
  if ((scene == BallScene::cradle && count <= 7) || count == 2) {
    draw_speeds(canvas, camera, simulation, balls);
  }
  if (scene == BallScene::tower) draw_tower_heights(canvas, camera, playback);
}

}  // namespace bounce
