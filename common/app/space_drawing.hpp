#pragma once
#include <Eigen/Core>
#include <span>
#include <string>

#include "app/camera.hpp"
#include "app/canvas.hpp"
#include "physics/shapes.hpp"

namespace bounce {

// Things in space, drawn through a camera. There is no depth buffer: who draws later is in front,
// so a picture draws floor, shadows, paths and balls in this order, and far balls before near ones.

/// A line through these points; what is behind the camera is cut off.
void draw_path(Canvas& canvas, const Camera& camera, std::span<const Eigen::Vector3d> points,
               Colour colour, float width);
void draw_dashed_path(Canvas& canvas, const Camera& camera, std::span<const Eigen::Vector3d> points,
                      Colour colour, float width);

/// A filled convex polygon.
void draw_patch(Canvas& canvas, const Camera& camera, std::span<const Eigen::Vector3d> corners,
                Colour colour);

/// Two unit vectors in the plane, square to each other: the first as far along x as the plane lets
/// it, the second along z on a level floor.
struct PlaneAxes {
  Eigen::Vector3d along, across;
};
PlaneAxes axes_of(const Plane& plane);

/// Squares with sides of `square` [m] on the plane around `centre`, paler and paler up to the
/// distance `reach` [m].
void draw_plane_grid(Canvas& canvas, const Camera& camera, const Plane& plane,
                     const Eigen::Vector3d& centre, double square, double reach);

/// The shadow of a ball on the plane, with the sun straight above.
void draw_shadow(Canvas& canvas, const Camera& camera, const Plane& plane,
                 const Eigen::Vector3d& ball, double radius);

/// The point of the plane straight above or below `point`.
Eigen::Vector3d below(const Plane& plane, const Eigen::Vector3d& point);

/// A ball with an outline and a soft shade: the light comes from the upper left.
void draw_ball_in_space(Canvas& canvas, const Camera& camera, const Eigen::Vector3d& centre,
                        double radius);

/// A label beside a place that the camera sees, shifted by so many pixels.
void draw_label_at(Canvas& canvas, const Camera& camera, const Eigen::Vector3d& place, Point shift,
                   const std::string& words, Colour colour, Align align = Align::left,
                   TextSize size = TextSize::tick);

/// Three short arrows that say where x, y and z point.
void draw_axes(Canvas& canvas, const Camera& camera, Point origin);

}  // namespace bounce
