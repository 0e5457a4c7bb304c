#pragma once
#include <numbers>

#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/sweep/numbers.hpp"

namespace bounce {

/// A ball that touches the floor: where in its swing the floor is then, and how fast the ball
/// comes, seen from the floor. With the scene that is all that the future depends on.
template <class V>
struct Touch {
  V angle;     // rad, 0 to 2 pi
  V velocity;  // m/s, negative
};

/// How that contact ends.
template <class V>
struct LiftOff {
  V t;                // s, since the touch
  V x, velocity;      // seen from the floor: height 0, or a little less where the contact lets go
  Swing<V> floor;     // the sine and cosine of the floor's angle
  Answer<V> is_sure;  // no where an earlier end might have been missed: then nothing here counts
};

/// Ball and floor, ready for quick contacts. Seen from the floor, whose swing is s = A sin(angle),
/// the height x of the ball above it obeys
///   in flight   x'' = -g - s''
///   in contact  x'' + 2 beta x' + omega0^2 x = -g - s''
/// so that in contact x is a constant, a swing with the floor, and a free swing that dies.
template <class V>
struct QuickContact {
  V gravity, amplitude, w, radius;  // m/s^2, m, rad/s, m
  V omega0, beta, omega_d;          // rad/s, 1/s, rad/s
  // A contact ends where a function X comes up through zero: the height x; or, where the contact
  // only pushes, omega0^2 x + 2 beta x', which is its push, downwards, by the mass. X is `level`, a
  // swing with the floor, Im(answer e^(i angle)), and a free swing.
  bool lets_go;
  V level;
  Swing<V> answer, undo_answer;
  V answer_size;
  // Half a free swing is the first guess at how long it lasts. What that does to swings:
  V half_swing;  // s
  Swing<V> floor_turn;
  V decay;

  LiftOff<V> operator()(const Touch<V>& touch, const Swing<V>& floor) const {
    const V stiff = omega0 * omega0, loss = 2 * beta, v = touch.velocity, one = V{1};
    const V shaking = amplitude * w * w;

    // The free swing: what is left of X when constant and steady swing are taken away.
    V value{}, rate = v;
    if (lets_go) {
      value = loss * v;
      rate = stiff * v + loss * (shaking * floor.sine - gravity - loss * v);
    }
    Swing<V> steady = floor * answer;
    Swing<V> free;
    free.sine = value - level - steady.sine;
    const V free_rate = rate - w * steady.cosine;
    free.cosine = (free_rate + beta * free.sine) / omega_d;
    const Derivatives<V> start = X(steady, free);
    // The energy of a free swing does not grow. So this stays above |X'''|:
    const V bound =
        w * w * w * answer_size +
        (stiff + loss * (loss + omega0)) * (absolute(free_rate) + omega0 * absolute(free.sine));

    LiftOff<V> end;
    V t = half_swing, step;
    steady = steady * floor_turn;
    free = {-decay * free.sine, -decay * free.cosine};
    Derivatives<V> now;
    for (int i = 0;; ++i) {
      now = X(steady, free);
      end.is_sure = now.first > 0;
      now.first = select(end.is_sure, now.first, one);  // anything to divide by
      step = now.step_to_zero();
      const Answer<V> is_near = now.is_near(step, omega0);
      end.is_sure = end.is_sure && is_near;
      if (all(is_near) || i == most_steps) break;
      step = select(is_near, V{}, within(step, eighth_turn / omega0));  // as far as series go
      t = t + step;
      steady = steady * small_turn(w * step);
      const Swing<V> turned = free * small_turn(omega_d * step);
      const V dying = small_exponential(-beta * step);
      free = {dying * turned.sine, dying * turned.cosine};
    }
    end.t = t + step;
    end.floor = steady * undo_answer * tiny_turn(w * step);
    const V end_rate = now.first_after(step);
    end.x = V{};
    end.velocity = end_rate;
    if (lets_go) {  // then x'' is that of a flight already
      end.velocity = (end_rate - loss * (shaking * end.floor.sine - gravity)) / stiff;
      end.x = -loss * end.velocity / stiff;
    }

    // It did not end before: X cannot have come up to zero in the first half of the time, starting
    // as it did, nor in the second half, ending as it does.
    const V half = end.t / 2, cubic = bound * half * half / 6;
    const V after = -start.first - start.second * half / 2 - cubic;
    const V before = end_rate - (now.second + now.third * step) * half / 2 - cubic;
    end.is_sure = end.is_sure && end.t > 0 && -v > 0 && -start.first > 0 &&
                  after > -close * start.first && before > close * end_rate && end.velocity > 0;
    end.velocity = select(end.is_sure, end.velocity, one);
    return end;
  }

 private:
  /// X and its derivatives. The free swing x is free.sine, and x' = omega_d cosine - beta sine.
  Derivatives<V> X(const Swing<V>& steady, const Swing<V>& free) const {
    const V w2 = w * w, stiff = omega0 * omega0, loss = 2 * beta;
    const V first = omega_d * free.cosine - beta * free.sine;
    const V second = -loss * first - stiff * free.sine;
    const V third = -loss * second - stiff * first;
    const V fourth = -loss * third - stiff * second;
    return {level + steady.sine + free.sine, w * steady.cosine + first, second - w2 * steady.sine,
            third - w2 * w * steady.cosine, fourth + w2 * w2 * steady.sine};
  }
};

/// It is for contacts with a damping ratio below 0.2, under gravity, on a floor that swings and
/// does no more. (Beyond, nearly every contact would have to be searched for after all.)
inline bool has_quick_contact(const OscillatingFloor& scene) {
  const double w = scene.angular_frequency, omega0 = natural_frequency(scene.stiffness, scene.mass);
  return scene.floor_law == FloorLaw::relative && scene.floor_velocity == 0 && scene.gravity > 0 &&
         w > 0 && w < omega0 / 2 && scene.damping < 0.4 * omega0 * scene.mass &&
         scene.amplitude > 0;
}

/// Of one scene, or of several side by side: `of` tells their parameters.
template <class V, class Of>
QuickContact<V> quick_contact(ContactLaw law, const Of& of) {
  QuickContact<V> quick;
  const V mass = of(&OscillatingFloor::mass), stiff = of(&OscillatingFloor::stiffness) / mass;
  const V w = of(&OscillatingFloor::angular_frequency);
  quick.gravity = of(&OscillatingFloor::gravity);
  quick.amplitude = of(&OscillatingFloor::amplitude);
  quick.w = w;
  quick.radius = of(&OscillatingFloor::radius);
  quick.omega0 = square_root(stiff);
  quick.beta = of(&OscillatingFloor::damping) / (2 * mass);
  quick.omega_d = square_root((quick.omega0 - quick.beta) * (quick.omega0 + quick.beta));
  // The steady answer to the shaking -s'' is that, divided by omega0^2 - w^2 + 2 beta w i.
  Swing<V> divisor{2 * quick.beta * w, stiff - w * w};
  quick.level = -quick.gravity / stiff;
  quick.lets_go = law == ContactLaw::push_only;
  if (quick.lets_go) {
    divisor = divisor * inverse(Swing<V>{divisor.sine, stiff});
    quick.level = -quick.gravity;
  }
  const V shaking = quick.amplitude * w * w;
  quick.undo_answer = {divisor.sine / shaking, divisor.cosine / shaking};
  quick.answer = inverse(quick.undo_answer);
  quick.answer_size = square_root(size_squared(quick.answer));
  quick.half_swing = std::numbers::pi / quick.omega_d;
  quick.floor_turn = turn(w * quick.half_swing);
  const V root = small_exponential(-quick.beta * quick.half_swing / 4);
  quick.decay = (root * root) * (root * root);
  return quick;
}

}  // namespace bounce
