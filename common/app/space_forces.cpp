#include "app/space_forces.hpp"

#include <cmath>
#include <string>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/peak_force.hpp"

namespace bounce {

using Eigen::Vector3d;

namespace {

constexpr double arrow_time = 0.12;  // s: a velocity arrow shows the way of this time

/// An arrow from `foot` (shifted sideways in the picture) along a force.
void draw_force(Canvas& canvas, const Camera& camera, const Vector3d& foot, float shift,
                const Vector3d& force, double weight, Colour colour, double share,
                const char* name) {
  const float pixels = force_length(force.norm(), weight);
  if (pixels < 1) return;
  const Vector3d end =
      foot + force.normalized() * static_cast<double>(pixels / camera.per_metre(foot));
  if (!camera.sees(foot) || camera.depth(end) < Camera::nearest) return;
  const Point a = camera.at(foot), b = camera.at(end);
  const Point from{a.x + shift, a.y}, to{b.x + shift, b.y};
  draw_arrow(canvas, from, to, colour.faded(share));
  if (*name == '\0' || std::hypot(to.x - from.x, to.y - from.y) < 14 || share < 0.4) return;
  const std::string words = std::string(name) + " " + with_unit(force.norm(), "N");
  // The damper's on its right; the others on their left, the weight's clear of the ball.
  const float gap = shift > 0 ? 8.0f : shift < 0 ? -8.0f : -26.0f;
  draw_label(canvas, {to.x + gap, to.y - 6}, words, palette::ink,
             shift > 0 ? Align::left : Align::right);
}

void draw_velocity(Canvas& canvas, const Camera& camera, const State<Vector3d>& state) {
  const Vector3d tip = state.position + arrow_time * state.velocity;
  if (!camera.sees(state.position) || camera.depth(tip) < Camera::nearest) return;
  const Point at = camera.at(tip);
  draw_arrow(canvas, camera.at(state.position), at, palette::motion, Shaft::velocity);
  if (state.velocity.norm() < 0.3) return;
  draw_label(canvas, {at.x + 14, at.y - 8}, with_unit(state.velocity.norm(), "m/s"), palette::ink);
}

}  // namespace

void draw_forces(Canvas& canvas, const Camera& camera, const Playback& playback, const View& view,
                 const BallInSpace& ball) {
  const State<Vector3d> state = state_in<Vector3d>(playback.shown_values());
  const Forces<Vector3d> now = ball.forces(playback.shown_time(), state);
  const double weight = now.gravity.norm();
  if (view.forces) draw_velocity(canvas, camera, state);
  draw_force(canvas, camera, state.position, 0, now.gravity, weight, palette::gravity, 1,
             ball.landings ? "" : "weight");  // there its words would cover the marks
  if (!view.forces) return;

  if (now.spring.norm() > 0) {
    const Vector3d foot = ball.plane.foot(state.position);
    draw_force(canvas, camera, foot, -10, now.spring, weight, palette::spring, 1, "spring");
    draw_force(canvas, camera, foot, 10, now.damper, weight, palette::damper, 1, "damper");
  } else if (const auto peak = peak_force<Vector3d>(playback, ball.forces)) {
    draw_force(canvas, camera, ball.plane.foot(peak->ball.position), -10, peak->spring, weight,
               palette::spring, 0.9 * peak->share, "spring, peak");
  }
}

}  // namespace bounce
