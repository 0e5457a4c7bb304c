#pragma once
#include "06_oscillating_floor/sweep/quick_contact.hpp"

namespace bounce {

/// The touch after a touch, and the flight before it.
template <class V>
struct NextTouch {
  Touch<V> touch;
  V highest;          // m, of the ball's centre
  Answer<V> is_sure;  // no where an event might have been missed: then nothing above counts
  LiftOff<V> from;    // may be sure all the same
};

/// A gap that opens with this velocity and acceleration, the last of which is never larger than
/// `most` and changes no faster than `jerk`, stays open for longer than this [s]: three quarters of
/// the time after which it can be zero again (root_free_time of first_zero.hpp).
template <class V>
V open_for(const V& velocity, const V& acceleration, const V& most, const V& jerk) {
  const V half = acceleration / 2;
  const V root = square_root(half * half + jerk * velocity * (2.0 / 3));
  return 0.75 * larger((half + root) * 3 / jerk, 2 * velocity / most);
}

/// From touch to touch with few evaluations: a guess that is improved until it is right, and then a
/// proof that nothing happened before. The proof fails for slow touches and grazing flights: they
/// need the search that walks by safe steps (exact.hpp).
template <class V>
NextTouch<V> next_touch(const QuickContact<V>& contact, const Touch<V>& touch) {
  const V gravity = contact.gravity, amplitude = contact.amplitude, w = contact.w;
  const V w2 = w * w, one = V{1};
  const Swing<V> at_touch = turn(touch.angle);
  const LiftOff<V> from = contact(touch, at_touch);

  // In the room: height over the middle of the swing, and velocity.
  const V y = from.x + amplitude * from.floor.sine;
  const V u = from.velocity + amplitude * w * from.floor.cosine;
  const V angle = touch.angle + w * from.t;

  // The first guess: the ball falls to where the floor was at the touch before.
  const V fall = u * u + 2 * gravity * (y - amplitude * at_touch.sine);
  V t = within((u + square_root(larger(fall, V{}))) / gravity, 1000 / w), step;
  Swing<V> floor = turn(angle + w * t);
  Derivatives<V> closing;  // of the gap, downwards
  NextTouch<V> next;
  for (int i = 0;; ++i) {
    const V height = amplitude * floor.sine, speed = amplitude * w * floor.cosine;
    closing = {height - (y + (u - gravity * t / 2) * t), speed - (u - gravity * t),
               gravity - w2 * height, -w2 * speed, w2 * w2 * height};
    next.is_sure = closing.first > 0;
    closing.first = select(next.is_sure, closing.first, one);  // anything to divide by
    step = closing.step_to_zero();
    const Answer<V> is_near = closing.is_near(step, w);
    next.is_sure = next.is_sure && is_near;
    if (all(is_near) || i == most_steps) break;
    step = select(is_near, V{}, within(step, eighth_turn / w));  // as far as series go
    t = t + step;
    floor = floor * small_turn(w * step);
  }
  t = t + step;
  next.touch.angle = within_turn(angle + w * t);
  next.touch.velocity = -closing.first_after(step);
  const V to_top = smaller(u / gravity, t);
  next.highest = contact.radius + y + (u - gravity * to_top / 2) * to_top;

  // Nothing happened before: for some time after the lift-off and before the touch the gap is
  // certain to be open, and in between the ball is above all that the floor does.
  const V shaking = amplitude * w2, most = gravity + shaking;
  const V start_bend = shaking * from.floor.sine - gravity;
  const V end_bend = -closing.second - closing.third * step;
  const V early = open_for(from.velocity, start_bend, most, shaking * w);
  const V late = t - open_for(larger(-next.touch.velocity, V{}), end_bend, most, shaking * w);
  const V y_early = y + (u - gravity * early / 2) * early;
  const V y_late = y + (u - gravity * late / 2) * late;
  const Answer<V> is_above = y_early > amplitude && y_late > amplitude;
  // A ball that was let go leaves the floor within twice -x / x', still rising, and is not pushed
  // again before.
  const V opened = -2 * from.x / from.velocity, slowest = from.velocity - most * opened;
  next.from = from;
  next.is_sure = next.is_sure && from.is_sure && t > 0 && -next.touch.velocity > 0 &&
                 (early > late || is_above) && opened * most < 0.3 * from.velocity &&
                 opened * gravity < u &&
                 contact.omega0 * contact.omega0 * slowest > 2 * contact.beta * most;
  return next;
}

}  // namespace bounce
