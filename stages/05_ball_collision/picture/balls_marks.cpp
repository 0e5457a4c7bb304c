#include "05_ball_collision/picture/balls_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double trail_length = 1.2;  // s

/// Where each ball is at these moments. (Before a change of scene there were others.)
template <class Points>
std::vector<std::vector<Vector3d>> paths(const Points& points, Eigen::Index count, double from = 0,
                                         double to = never) {
  std::vector<std::vector<Vector3d>> all(static_cast<std::size_t>(count));
  for (const TracePoint& point : points) {
    if (point.t < from || point.t > to) continue;
    const Balls balls = balls_in(point.values);
    if (balls.position.cols() != count) continue;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].push_back(balls.position.col(static_cast<Eigen::Index>(i)));
    }
  }
  return all;
}

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

void draw_trails(Canvas& canvas, const Camera& camera, const Playback& playback,
                 Eigen::Index count) {
  const double now = playback.shown_time();
  for (const std::vector<Vector3d>& path :
       paths(playback.trace(), count, now - trail_length, now)) {
    for (std::size_t i = 0; i + 1 < path.size(); i += 24) {
      const std::size_t points = std::min<std::size_t>(25, path.size() - i);
      const double age = 1 - static_cast<double>(i) / static_cast<double>(path.size());
      draw_path(canvas, camera, std::span(path).subspan(i, points),
                palette::motion.faded(0.7 * (1 - 0.85 * age)), 1.5f);
    }
  }
}

void draw_futures(Canvas& canvas, const Camera& camera, const std::vector<TracePoint>& future,
                  Eigen::Index count, bool earlier) {
  for (const std::vector<Vector3d>& path : paths(future, count)) {
    if (earlier) draw_dashed_path(canvas, camera, path, palette::exact.faded(0.5), 1);
    if (!earlier) draw_path(canvas, camera, path, palette::motion.faded(0.3), 2);
  }
}

void draw_ghosts(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const Balls& exact) {
  for (Eigen::Index ball = 0; ball < exact.position.cols(); ++ball) {
    const Vector3d at = exact.position.col(ball);
    if (!camera.sees(at)) continue;
    const auto size = static_cast<float>(scene.radius[ball] * camera.per_metre(at));
    draw_dashed_circle(canvas, camera.at(at), std::max(3.0f, size), palette::exact, 1.5f);
  }
}

void draw_arrows(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const Balls& balls) {
  const Eigen::Index count = balls.position.cols();
  for (Eigen::Index i = 0; i < count; ++i) {
    const Ball ball = scene.ball(balls, i);
    const Vector3d tip = ball.position + 0.25 * ball.velocity;
    if (!camera.sees(ball.position) || !camera.sees(tip) || ball.velocity.norm() < 0.02) continue;
    draw_arrow(canvas, camera.at(ball.position), camera.at(tip), palette::motion, Shaft::velocity);
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = i + 1; j < count; ++j) {
      const Ball one = scene.ball(balls, i), two = scene.ball(balls, j);
      const Vector3d force = pair_force(one, two, scene.pair_contact());
      const Vector3d touch = one.position - one.radius * meet(one, two).e12;
      if (force.isZero() || !camera.sees(touch)) continue;
      const Vector3d arrow = force.normalized() * std::min(0.5, 0.02 * std::sqrt(force.norm()));
      draw_arrow(canvas, camera.at(touch), camera.at(touch + arrow), palette::spring);
      draw_arrow(canvas, camera.at(touch), camera.at(touch - arrow), palette::spring);
    }
  }
}

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
