#pragma once
#include <algorithm>
#include <cmath>

#include "08_racket_game/racket_game.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/stability.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

/// No piece of a contact may be longer than this [s]: a 2000th of the largest stable step, so
/// that a contact is made of some 3000 pieces. The first-order methods then give the speed after a
/// bounce to three digits.
inline double longest_contact_piece(const Racket& scene) {
  const double omega0 = natural_frequency(scene.stiffness, scene.mass);
  const double zeta = damping_ratio(scene.stiffness, scene.damping, scene.mass);
  return semi_implicit_euler_limit(zeta) / omega0 / 2000;
}

/// Where nobody notes what a contact is made of.
struct NoNote {
  void operator()(const auto&...) const {}
};

/// Moves a ball by one step that sees every touch, however fast the racket is. In a step of 10 ms a
/// racket at 15 m/s moves by 15 cm: looked at between the steps only, it would pass through the
/// ball, or be found deep inside it and fling it away. So the step is cut at the touch, and is made
/// of small pieces during the contact.
///
/// In flight the force is known beforehand, and the parabola of stage 1 moves the ball: the touch
/// is found on it without an error of the method. The method has the contact to itself.
///
/// The method begins afresh in each contact: what it carries from step to step (velocity Verlet) is
/// of no use after a touch. `note(scene, t, before, after, dt)` is called after each of its pieces.
template <class Method, class Note = NoNote>
class ContactSteps {
 public:
  explicit ContactSteps(Racket& scene, const Note& note = {}) : scene_(scene), note_(note) {}

  void operator()(double t, State<Eigen::Vector3d>& state, double dt);

  long long pieces = 0;  // steps of the method, in contact
  long long touches = 0;

 private:
  using Ball = State<Eigen::Vector3d>;

  /// A step that is made of more pieces or looks than this would be seconds of work that nobody can
  /// interrupt. Numbers that are far apart ask for it: a stiff contact in a very long step.
  static constexpr long long most_work = 10000000;
  void count_work(double t) {
    if (++work_ <= most_work) return;
    throw TimeStandsStill(t, "a step would need more than 1e7 pieces",
                          "take a shorter --dt, a softer contact or lower speeds");
  }

  /// Distance between the surfaces of ball and racket [m]; negative when they overlap.
  double gap(double t, const Ball& ball) const {
    return scene_.nearest(scene_.disc_at(t), ball.position).distance - scene_.radius;
  }

  Ball flown(const Ball& start, double t) const {
    return fly<Eigen::Vector3d>(start, {0, -scene_.gravity, 0}, t);
  }

  /// In contact for `left` seconds, or until the ball is off. Returns how long.
  double contact(double t, Ball& ball, double left) {
    Method step{};
    const double count = std::ceil(left / longest_contact_piece(scene_));
    const double piece = left / count;
    double done = 0;
    for (double i = 0; i < count && gap(t + done, ball) < 0; ++i) {
      count_work(t + done);
      const Ball before = ball;
      step(scene_, t + done, ball, piece);
      note_(scene_, t + done, before, ball, piece);
      done = i + 1 < count ? done + piece : left;
      scene_.choose_side(t + done, ball.position);
      ++pieces;
    }
    return done;
  }

  /// When the flying ball meets the racket [s], at most `left`. The gap cannot close faster than
  /// `speed`, so nothing happens within gap / speed: go there, look again (conservative
  /// advancement; Mirtich 1996).
  double time_to_touch(double t, const Ball& start, double left) {
    const Disc racket = scene_.disc_at(t);
    const double speed = (start.velocity - racket.velocity).norm() +
                         racket.angular_velocity.norm() * racket.radius + scene_.gravity * left;
    const double near = 1e-6 * scene_.radius;
    double later = 0;
    double distance = gap(t, start);
    while (distance < speed * (left - later)) {
      count_work(t + later);
      if (distance < near) {
        // Is there an overlap a little later? Then the touch is in between.
        const double beyond = std::min(left, later + 16 * near / speed);
        if (gap(t + beyond, flown(start, beyond)) < 0) return touch(t, start, later, beyond);
      }
      later += std::max(distance, near) / speed;
      distance = gap(t + later, flown(start, later));
      if (distance < 0) return touch(t, start, later - near / speed, later);
    }
    return left;
  }

  /// Halves the time between `before` the touch and `after` it until they meet; returns the later.
  double touch(double t, const Ball& start, double before, double after) {
    ++touches;
    for (int i = 0; i < 60; ++i) {
      const double middle = (before + after) / 2;
      (gap(t + middle, flown(start, middle)) < 0 ? after : before) = middle;
    }
    return after;
  }

  Racket& scene_;
  const Note note_;
  long long work_ = 0;  // pieces and looks of this step
};

template <class Method, class Note>
void ContactSteps<Method, Note>::operator()(double t, State<Eigen::Vector3d>& state, double dt) {
  const double end = t + dt;
  work_ = 0;
  double left = dt;
  while (left > 0) {
    double piece;
    if (gap(t, state) < 0) {
      piece = contact(t, state, left);
    } else {
      piece = time_to_touch(t, state, left);
      state = flown(state, piece);
    }
    left -= piece;
    t = left > 0 ? t + piece : end;
    scene_.choose_side(t, state.position);
  }
}

/// How many touches a step saw, and in how many pieces of contact it was taken.
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

template <class Method, class Note = NoNote>
RacketStep racket_step(Method& method, Racket& scene, double t, State<Eigen::Vector3d>& ball,
                       double dt, const Note& note = {}) {
  if (is_mine) return whole_step(method, scene, t, ball, dt);
  ContactSteps<Method, Note> steps(scene, note);
  steps(t, ball, dt);
  return {steps.touches, steps.pieces};
}

}  // namespace bounce
