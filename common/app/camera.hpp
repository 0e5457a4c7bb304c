#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "app/canvas.hpp"

namespace bounce {

/// A pinhole camera: it stands at `eye`, looks at `target`, and what is far away is small. All is
/// in metres but the picture, which is in pixels.
class Camera {
 public:
  static constexpr double nearest = 0.05;  // m; what is closer, or behind, cannot be drawn
  static constexpr double margin = 100;    // px around the picture that are still drawn

  /// `up` is up in the picture (not along the line of sight); `opening` is the angle from the lower
  /// to the upper edge of `area` [degrees].
  Camera(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up,
         Rect area, double opening)
      : eye_(eye),
        forward_((target - eye).normalized()),
        right_(forward_.cross(up).normalized()),
        up_(right_.cross(forward_)),
        centre_{area.x + area.width / 2, area.y + area.height / 2},
        focal_(area.height / 2 / std::tan(opening * std::numbers::pi / 360)),
        half_width_(area.width / 2 + margin),
        half_height_(area.height / 2 + margin) {}

  /// Distance along the line of sight [m].
  double depth(const Eigen::Vector3d& point) const { return forward_.dot(point - eye_); }

  /// Where a point is in the picture. Its depth must be `nearest` at least.
  Point at(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d sight = point - eye_;
    const double pixels = focal_ / forward_.dot(sight);  // a metre there
    return {centre_.x + static_cast<float>(right_.dot(sight) * pixels),
            centre_.y - static_cast<float>(up_.dot(sight) * pixels)};
  }

  /// How many pixels a metre has at that point.
  float per_metre(const Eigen::Vector3d& point) const {
    return static_cast<float>(focal_ / depth(point));
  }

  /// The point that is seen at `pixel` and lies as deep as `like`: what a mouse can grab.
  Eigen::Vector3d under(Point pixel, const Eigen::Vector3d& like) const {
    return like + across({pixel.x - at(like).x, pixel.y - at(like).y}, like);
  }

  /// A shift in the picture [px] as a shift in space [m] at the depth of `like`.
  Eigen::Vector3d across(Point shift, const Eigen::Vector3d& like) const {
    return (right_ * static_cast<double>(shift.x) - up_ * static_cast<double>(shift.y)) /
           static_cast<double>(per_metre(like));
  }

  /// What can be seen is a pyramid without its tip. How far inside each of its five faces a point
  /// is (negative: outside), in a measure that is linear in the point, so that lines can be cut
  /// there.
  std::array<double, 5> inside(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d sight = point - eye_;
    const double depth = forward_.dot(sight);
    const double x = focal_ * right_.dot(sight), y = focal_ * up_.dot(sight);
    return {depth - nearest, half_width_ * depth - x, half_width_ * depth + x,
            half_height_ * depth - y, half_height_ * depth + y};
  }
  bool sees(const Eigen::Vector3d& point) const {
    for (const double face : inside(point)) {
      if (!(face >= 0)) return false;
    }
    return true;
  }

  const Eigen::Vector3d& right() const { return right_; }
  const Eigen::Vector3d& up() const { return up_; }

 private:
  Eigen::Vector3d eye_, forward_, right_,
      up_;  // the last three: unit vectors, square to each other
  Point centre_;
  double focal_;                     // px
  double half_width_, half_height_;  // px, with the margin
};

/// Of the camera of balls in space [degrees].
inline constexpr double usual_opening = 34;

/// Where one looks at a scene from: `distance` in front of it, a little from the left and from
/// above; or from far above, where height hardly shifts a point in the picture: a map.
inline Camera camera_before(const Eigen::Vector3d& target, double distance, double steepness,
                            Rect area, bool from_above) {
  if (from_above) {
    const Eigen::Vector3d eye = target + Eigen::Vector3d(0, 20 * distance, 0);
    return {eye, target, {0, 0, -1}, area, usual_opening / 20};
  }
  const Eigen::Vector3d direction = Eigen::Vector3d(-0.10, steepness, 0.95).normalized();
  return {target + distance * direction, target, {0, 1, 0}, area, usual_opening};
}

}  // namespace bounce
