#include "05_ball_collision/picture/balls_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/space_drawing.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double trail_length = 1.2;  // s

}  // namespace

void draw_trails(Canvas& canvas, const Camera& camera, const Playback& playback,
                 std::size_t balls) {
  for (std::size_t ball = 0; ball < balls; ++ball) {
    std::vector<Vector3d> path;
    for (const TracePoint& point : playback.trace()) {
      if (point.t < playback.shown_time() - trail_length || point.t > playback.shown_time())
        continue;
      if (point.values.size() == 7 * balls) path.push_back(position(point.values, ball));
    }
    for (std::size_t i = 0; i + 1 < path.size(); i += 24) {
      const std::size_t count = std::min<std::size_t>(25, path.size() - i);
      const double age = 1 - static_cast<double>(i) / static_cast<double>(path.size());
      draw_path(canvas, camera, std::span(path).subspan(i, count),
                palette::motion.faded(0.7 * (1 - 0.85 * age)), 1.5f);
    }
  }
}

void draw_futures(Canvas& canvas, const Camera& camera, const std::vector<TracePoint>& future,
                  std::size_t balls, bool earlier) {
  for (std::size_t ball = 0; ball < balls; ++ball) {
    std::vector<Vector3d> path;
    for (const TracePoint& point : future) {
      if (point.values.size() == 7 * balls) path.push_back(position(point.values, ball));
    }
    if (earlier) draw_dashed_path(canvas, camera, path, palette::exact.faded(0.5), 1);
    if (!earlier) draw_path(canvas, camera, path, palette::motion.faded(0.3), 2);
  }
}

void draw_ghosts(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const std::vector<double>& exact) {
  for (std::size_t ball = 0; 7 * ball < exact.size(); ++ball) {
    const Vector3d at = position(exact, ball);
    if (!camera.sees(at)) continue;
    const double radius = scene.radius[static_cast<Eigen::Index>(ball)];
    const auto size = static_cast<float>(radius * camera.per_metre(at));
    draw_dashed_circle(canvas, camera.at(at), std::max(3.0f, size), palette::exact, 1.5f);
  }
}

void draw_arrows(Canvas& canvas, const Camera& camera, const BallCollision& scene,
                 const std::vector<double>& rows, std::size_t balls) {
  const auto at = [&](std::size_t i) {
    return Ball{position(rows, i), velocity(rows, i), scene.radius[static_cast<Eigen::Index>(i)]};
  };
  for (std::size_t i = 0; i < balls; ++i) {
    const Ball ball = at(i);
    const Vector3d tip = ball.position + 0.25 * ball.velocity;
    if (!camera.sees(ball.position) || !camera.sees(tip) || ball.velocity.norm() < 0.02) continue;
    draw_arrow(canvas, camera.at(ball.position), camera.at(tip), palette::motion, Shaft::velocity);
  }
  for (std::size_t i = 0; i < balls; ++i) {
    for (std::size_t j = i + 1; j < balls; ++j) {
      const Vector3d force = pair_force(at(i), at(j), scene.pair_contact());
      const Vector3d touch = at(i).position - at(i).radius * meet(at(i), at(j)).e12;
      if (force.isZero() || !camera.sees(touch)) continue;
      const Vector3d arrow = force.normalized() * std::min(0.5, 0.02 * std::sqrt(force.norm()));
      draw_arrow(canvas, camera.at(touch), camera.at(touch + arrow), palette::spring);
      draw_arrow(canvas, camera.at(touch), camera.at(touch - arrow), palette::spring);
    }
  }
}

}  // namespace bounce
