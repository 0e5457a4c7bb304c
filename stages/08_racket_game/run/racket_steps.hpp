#pragma once
#include "08_racket_game/run/contact_steps.hpp"
#include "run/any_method.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

/// A step of `method` that sees every touch (contact_steps.hpp). Returns how many touches it saw,
/// and in how many pieces of contact it was taken. `note(scene, t, before, after, dt)` is called
/// after each of these, unless it is nullptr.
struct RacketStep {
  long long touches, pieces;
};

/// On a learner's lines there are no flights by formula and no cuts: a step is one step of the
/// method, and only the learner's force says where the ball goes. Between two steps the racket may
/// have moved, so what the method remembers does not hold.
template <class Method>
RacketStep whole_step(Method& method, Racket& scene, double t, State<Eigen::Vector3d>& ball,
                      double dt) {
  const auto touches = [&](double when) {
    return scene.nearest(scene.disc_at(when), ball.position).distance < scene.radius;
  };
  const bool before = touches(t);
  if constexpr (requires { method.forget(); }) {
    method.forget();
  } else {
    method = {};
  }
  method(scene, t, ball, dt);
  scene.choose_side(t + dt, ball.position);
  return {!before && touches(t + dt) ? 1 : 0, 1};
}

template <class Method, class Note>
RacketStep racket_step(Method& method, Racket& scene, double t, State<Eigen::Vector3d>& ball,
                       double dt, const Note& note) {
  if (is_mine) return whole_step(method, scene, t, ball, dt);
  const auto make_step = [&] {
    return [&, fresh = Method{}](const Racket& law, double now, State<Eigen::Vector3d>& x,
                                 double h) mutable {
      if constexpr (std::is_null_pointer_v<Note>) {
        fresh(law, now, x, h);
      } else {
        const State<Eigen::Vector3d> before = x;
        fresh(law, now, x, h);
        note(law, now, before, x, h);
      }
    };
  };
  ContactSteps steps(scene, make_step);
  steps(t, ball, dt);
  return {steps.touches, steps.pieces};
}

}  // namespace bounce
