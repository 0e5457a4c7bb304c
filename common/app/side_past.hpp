#pragma once
#include <functional>
#include <vector>

#include "app/drawing.hpp"
#include "app/layout.hpp"
#include "app/side_view.hpp"

namespace bounce {

// The parts of the side view that show where the ball has been and where it will go.

constexpr float ruler_x = 64;              // px
constexpr float strobe_ghost_offset = 96;  // px between the ball's images and the exact ones

inline float column_x(const BallOnALine& ball) {
  return layout::scene.width * (ball.strobe ? 0.36f : 0.60f);
}
inline double height_of(const std::vector<double>& values) {
  return state_in<double>(values).position;
}

/// Height against time: the present is the ball's column.
class TimePath {
 public:
  static constexpr float pixels_per_second = 130;

  TimePath(const SideCamera& camera, float column, double now)
      : camera_(camera), column_(column), now_(now) {}
  Point at(double t, double y) const {
    return {column_ + static_cast<float>(t - now_) * pixels_per_second, camera_.at(0, y).y};
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

/// What the trace holds, to the left of the ball: height against time, and the tops' heights.
void draw_past(Canvas& canvas, const Playback& playback, const TimePath& path,
               const BallOnALine& ball, const View& view);

/// The same as images of the ball, one every tenth of a second, beside those of the exact solution.
void draw_strobe(Canvas& canvas, const Playback& playback, const SideCamera& camera, float x,
                 float radius, bool ghost);

void draw_time_axis(Canvas& canvas, const TimePath& path, double now, float y, float column);

}  // namespace bounce
