#include "app/side_forces.hpp"

#include <algorithm>
#include <cmath>

#include "app/drawing.hpp"
#include "app/palette.hpp"
#include "app/peak_force.hpp"

namespace bounce {
namespace {

constexpr float per_metre_per_second = 9;  // px of the velocity arrow

/// An arrow up or down from `from`, with its name and size beside the tip: on the spring's side
/// (left) or on the damper's.
void draw_force(Canvas& canvas, Point from, double force, double weight, Colour colour,
                double share, const std::string& name, Align side) {
  const float length = force_length(force, weight);
  if (length < 1) return;
  const Point tip{from.x, from.y - std::copysign(length, static_cast<float>(force))};
  draw_arrow(canvas, from, tip, colour.faded(share));
  if (length < 14 || share < 0.4 || name.empty()) return;
  const float away = side == Align::right ? -8.0f : 8.0f;
  draw_label(canvas, {tip.x + away, tip.y - (force > 0 ? 2 : 12)},
             name + " " + with_unit(std::abs(force), "N"), palette::ink, side);
}

}  // namespace

void draw_forces(Canvas& canvas, const Playback& playback, const View& view,
                 const BallOnALine& ball, Point centre, float radius, float ground) {
  const Forces<double> now =
      ball.forces(playback.shown_time(), state_in<double>(playback.shown_values()));
  const double weight = std::abs(now.gravity);
  draw_force(canvas, centre, now.gravity, weight, palette::gravity, 1, "", Align::left);
  if (weight > 0) {  // beside the ball, where no other arrow comes
    const Point at = ball.strobe ? Point{centre.x, centre.y + radius + 16}
                                 : Point{centre.x - radius - 8, centre.y - 8};
    draw_label(canvas, at, "weight " + with_unit(weight, "N"), palette::ink,
               ball.strobe ? Align::centre : Align::right);
  }
  if (!view.forces) return;

  const Point contact{centre.x, std::min(ground, centre.y + radius)};
  const Point left{contact.x - 10, contact.y}, right{contact.x + 10, contact.y};
  if (now.spring != 0) {
    draw_force(canvas, left, now.spring, weight, palette::spring, 1, "spring", Align::right);
    draw_force(canvas, right, now.damper, weight, palette::damper, 1, "damper", Align::left);
  } else if (const auto peak = peak_force<double>(playback, ball.forces)) {
    draw_force(canvas, {left.x, ground}, peak->spring, weight, palette::spring, 0.9 * peak->share,
               "spring, peak", Align::right);
  }
  const double speed = state_in<double>(playback.shown_values()).velocity;
  const Point foot{centre.x + radius + 40, centre.y};
  const Point tip{foot.x, foot.y - static_cast<float>(speed) * per_metre_per_second};
  draw_arrow(canvas, foot, tip, palette::motion, Shaft::velocity);
  if (std::abs(speed) > 0.5) {
    draw_label(canvas, {tip.x + 10, tip.y - 8}, with_unit(speed, "m/s"), palette::ink);
  }
}

}  // namespace bounce
