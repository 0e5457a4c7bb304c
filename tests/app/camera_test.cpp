#include "app/camera.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "app/space_drawing.hpp"

using namespace bounce;
using Eigen::Vector3d;

namespace {

constexpr Rect area{100, 50, 640, 480};

/// Remembers the corners of all that is drawn.
struct Corners final : Canvas {
  std::vector<Point> points;
  void line(std::span<const Point> all, Colour, float) override {
    points.insert(points.end(), all.begin(), all.end());
  }
  void fill(std::span<const Point> all, Colour) override {
    points.insert(points.end(), all.begin(), all.end());
  }
  void circle(Point, float, Colour, float) override {}
  void disc(Point, float, Colour) override {}
  void text(Point, std::string_view, Colour, Align, TextSize) override {}
  void ball(Point, float, Colour) override {}
  float text_width(std::string_view, TextSize) const override { return 0; }
  void push_clip(Rect) override {}
  void pop_clip() override {}
};

}  // namespace

TEST_CASE("the camera is a pinhole") {
  // It opens by 90 degrees: at a distance of 2 m the picture is 4 m high.
  const Camera camera({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, area, 90);
  struct Case {
    Vector3d point;
    float x, y;
  };
  for (const Case& seen : {Case{{0, 0, 0}, 420, 290},   // the middle
                           Case{{0, 2, 0}, 420, 50},    // the upper edge: y is up
                           Case{{2, 0, 0}, 660, 290},   // x to the right
                           Case{{2, 0, -2}, 540, 290},  // twice as far, half as large
                           Case{{1, -1, 1}, 660, 530}}) {
    CAPTURE(seen.x);
    CAPTURE(seen.y);
    CHECK(std::abs(camera.at(seen.point).x - seen.x) <
          0.001f);  // pixels are floats: 1e-4 of rounding
    CHECK(std::abs(camera.at(seen.point).y - seen.y) < 0.001f);
  }
  CHECK(std::abs(camera.per_metre({1, 1, 0}) - 120) < 0.001f);
  // What the mouse grabs at a point's own pixel is that point.
  const Vector3d point(0.3, -0.7, 0.4);
  CHECK((camera.under(camera.at(point), point) - point).norm() < 1e-6);
}

TEST_CASE("what lies outside the picture is cut off, also behind the camera and far away") {
  // SDL's software renderer crashes on huge coordinates.
  const Camera camera({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, area, 90);
  Corners canvas;
  const std::vector<Vector3d> path{{0, 0, 0},    {0, 0, 5},        {1e12, 3, -1},
                                   {0, 0.1, 0},  {-1e15, 0, 2},    {0.2, 0, 0},
                                   {1, 1, 1.99}, {1e9, 1e9, -1e9}, {0, 0, -1e15}};
  draw_path(canvas, camera, path, Colour{}, 1);
  draw_patch(canvas, camera, path, Colour{});
  const std::array<Vector3d, 3> hidden{Vector3d(0, 0, 3), {5, 0, 4}, {0, 7, 9}};
  draw_plane_grid(canvas, camera, Plane{{0, 1, 0}, 1}, {0, 0, 0}, 0.5, 100);
  CHECK(canvas.points.size() > 10);
  for (const Point& point : canvas.points) {
    const double slack = Camera::margin + 1;
    REQUIRE(point.x >= area.x - slack);
    REQUIRE(point.x <= area.right() + slack);
    REQUIRE(point.y >= area.y - slack);
    REQUIRE(point.y <= area.bottom() + slack);
  }
  Corners nothing;
  draw_path(nothing, camera, hidden, Colour{}, 1);
  draw_patch(nothing, camera, hidden, Colour{});
  CHECK(nothing.points.empty());
}
