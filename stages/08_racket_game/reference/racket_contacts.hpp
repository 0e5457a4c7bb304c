#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "08_racket_game/racket_game.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/first_zero.hpp"
#include "physics/events/reference_walk.hpp"

namespace bounce {

/// The contacts of ball and racket in the form that `Reference` (reference_walk.hpp) asks for, face
/// and rim. Seen from a racket in uniform motion that does not turn: positions and velocities count
/// from its centre, and the racket rests.
class RacketContacts {
 public:
  using Ball = State<Eigen::Vector3d>;

  /// What the ball touches: the disc, its rim, or - pressed through the disc and out over its rim -
  /// what Racket::beyond_rim() makes of it.
  enum class Place { face, rim, beyond };
  enum class Event { overlap, push, inside, height };

  RacketContacts(const Racket& scene, const Ball& ball)
      : scene_(scene), gravity_(0, -scene.gravity, 0), side_(scene.side) {
    const InRimPlane at = in_rim_plane(ball);
    place_ = at.x < 0 ? Place::face : scene.through && at.y < 0 ? Place::beyond : Place::rim;
    const Gap gap = gap_of(place_, at);
    const double overlap = scene_.radius - gap.d;
    const double push = scene_.stiffness * overlap - scene_.damping * gap.rate(at);
    if (overlap > 0) phase_ = only_pushes() && push <= 0 ? Phase::let_go : Phase::touch;
  }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit.whole("place", self.place_, 0, 2);
    visit("phase", self.phase_);
  }

  Phase phase() const { return phase_; }
  Place place() const { return place_; }
  int side() const { return side_; }

  // ---- Flight

  bool in_flight() const { return phase_ == Phase::flight; }
  Ball fly(const Ball& start, double t) const { return bounce::fly(start, gravity_, t); }

  /// The disc is convex, so that the distance to it is a convex function of where the ball is: in
  /// flight its second derivative is never below -g. That is enough to miss no touch.
  double flight_time(double /*t*/, const Ball& start) {
    const double g = gravity_.norm();
    // A ball that is below the whole racket and falls does not come back.
    const double low = -dot(start.position, gravity_) / std::max(g, 1e-300);
    const double away = scene_.disc.radius + scene_.radius;
    const double until =
        g > 0 ? time_to_fall(std::max(0.0, low + away), -dot(start.velocity, gravity_) / g, g)
              : never;
    const auto gap_at = [&](double t) {
      const InRimPlane at = in_rim_plane(fly(start, t));
      const Gap gap =
          at.x < 0 ? Gap{std::abs(at.y), 0, at.y < 0 ? -1.0 : 1.0} : gap_of(Place::rim, at);
      return BoundedValue{gap.d - scene_.radius, gap.rate(at), gap.bend(at, gravity_), g, 0};
    };
    const BoundedValue first = gap_at(0);
    // From a touch without speed it can only be pulled off.
    const bool hangs = first.value <= 0 && first.slope == 0 && first.bend > 0;
    const double begin = hangs ? std::sqrt(1e-12 * scene_.radius / first.bend) : 0;
    const FirstZero touch = first_zero(gap_at, begin, until, 1000);
    lands_ = touch.found;
    return touch.found || touch.t <= until ? touch.t : never;
  }
  void land(double /*t*/, Ball& ball) {
    if (!lands_) return;  // the search goes on from here
    side_ = dot(scene_.disc.normal, ball.position) < 0 ? -1 : 1;
    place_ = in_rim_plane(ball).x < 0 ? Place::face : Place::rim;
    phase_ = Phase::touch;
  }

  // ---- Contact

  Eigen::Vector3d acceleration(double /*t*/, const Ball& ball) const {
    if (phase_ != Phase::touch) return gravity_;
    const InRimPlane at = in_rim_plane(ball);
    const Gap gap = gap_of(place_, at);
    const double push = scene_.stiffness * (scene_.radius - gap.d) - scene_.damping * gap.rate(at);
    return gravity_ + push / scene_.mass * (gap.dx * at.out + gap.dy * at.up);
  }
  double time_scale() const {
    return 1 / (std::sqrt(scene_.stiffness / scene_.mass) + scene_.damping / scene_.mass);
  }

  std::array<Event, 4> events(const Ball&, double) const {
    return {Event::overlap, Event::push, Event::inside, Event::height};
  }
  /// Positive until it happens; the constant 1 for what cannot happen now.
  EventValue event_value(Event event, double /*t*/, const Ball& ball,
                         const Eigen::Vector3d& a) const {
    const InRimPlane at = in_rim_plane(ball);
    const Gap gap = gap_of(place_, at);
    const double rate = gap.rate(at);
    switch (event) {
      case Event::overlap:  // a contact that only pushes has let go before
        if (phase_ == Phase::touch && only_pushes()) break;
        return {scene_.radius - gap.d, -rate};
      case Event::push: {
        if (!only_pushes()) break;
        const double sign = phase_ == Phase::touch ? 1 : -1;
        return {sign * (scene_.stiffness * (scene_.radius - gap.d) - scene_.damping * rate),
                sign * (-scene_.stiffness * rate - scene_.damping * gap.bend(at, a))};
      }
      case Event::inside: {  // by squares, which are smooth at the disc's centre as well
        const double sign = place_ == Place::face ? -1 : 1;
        return {sign * at.x * (at.lateral + scene_.disc.radius), sign * 2 * at.lateral * at.vx};
      }
      case Event::height:
        if (place_ != Place::beyond) break;
        return {-at.y, -at.vy};
    }
    return {1, 0};
  }

  double rounding(Event, const Ball&) const { return 0; }
  /// Without a force any step is accurate, and might jump over the rest of the overlap.
  bool resolves(const Ball& before, const Ball& after, double) const {
    return place_ == Place::face || phase_ == Phase::touch ||
           (after.position - before.position).norm() <= scene_.radius / 2;
  }

  void pass(Event event, double /*t*/, Ball& ball) {
    switch (event) {
      case Event::overlap:
        phase_ = Phase::flight;
        return;
      case Event::push:
        phase_ = phase_ == Phase::touch ? Phase::let_go : Phase::touch;
        return;
      case Event::height:
        place_ = Place::rim;
        return;
      case Event::inside:
        if (place_ == Place::face) {
          place_ = in_rim_plane(ball).y < 0 ? Place::beyond : Place::rim;
        } else {
          // From the rim onto the disc, on the side on which it is.
          if (place_ == Place::rim && in_rim_plane(ball).y < 0) side_ = -side_;
          place_ = Place::face;
        }
        return;
    }
  }

 private:
  bool only_pushes() const { return scene_.contact == ContactLaw::push_only && scene_.damping > 0; }

  /// The ball in the plane through the disc's axis and the ball's centre: x outwards from the
  /// rim, y up from the disc on the ball's side.
  struct InRimPlane {
    Eigen::Vector3d out, up;  // unit vectors along x and y
    double lateral;           // m, from the axis
    double x, y;              // m
    double vx, vy;            // m/s
    double turn;  // m/s^2: x'' of a ball that is not accelerated but goes round the axis
  };
  InRimPlane in_rim_plane(const Ball& ball) const {
    InRimPlane at;
    at.up = side_ * scene_.disc.normal;
    at.y = dot(at.up, ball.position);
    const Eigen::Vector3d along = ball.position - at.y * at.up;
    at.lateral = along.norm();
    at.out = at.lateral > 0 ? Eigen::Vector3d(along / at.lateral) : Eigen::Vector3d::Zero();
    at.x = at.lateral - scene_.disc.radius;
    at.vy = dot(at.up, ball.velocity);
    at.vx = dot(at.out, ball.velocity);
    const Eigen::Vector3d round = ball.velocity - at.vy * at.up - at.vx * at.out;
    at.turn = at.lateral > 0 ? round.squaredNorm() / at.lateral : 0;
    return at;
  }

  /// The distance d(x, y) with its derivatives. The force is the push times its gradient.
  struct Gap {
    double d, dx, dy;
    double dxx = 0, dxy = 0, dyy = 0;

    double rate(const InRimPlane& s) const { return dx * s.vx + dy * s.vy; }
    /// The second derivative by time, for a ball that is accelerated by `a`.
    double bend(const InRimPlane& s, const Eigen::Vector3d& a) const {
      return dx * (dot(s.out, a) + s.turn) + dy * dot(s.up, a) + dxx * s.vx * s.vx +
             2 * dxy * s.vx * s.vy + dyy * s.vy * s.vy;
    }
  };
  static Gap gap_of(Place place, const InRimPlane& at) {
    if (place == Place::face) return {at.y, 0, 1};
    const double length = std::hypot(at.x, at.y);
    if (length == 0) return {0, 0, 1};
    const double x = at.x / length, y = at.y / length, xx = x * x, yy = y * y;
    if (place == Place::rim) return {length, x, y, yy / length, -x * y / length, xx / length};
    return {length * (xx - yy),
            x * (1 + 2 * yy),
            -y * (1 + 2 * xx),
            yy * (1 + 2 * yy - 4 * xx) / length,
            x * y * (4 * xx - 2 * yy - 1) / length,
            -xx * (1 + 2 * xx - 4 * yy) / length};
  }

  Racket scene_;
  Eigen::Vector3d gravity_;  // m/s^2
  int side_;                 // from which the ball touches, or touched last
  Phase phase_ = Phase::flight;
  Place place_ = Place::face;
  bool lands_ = false;
};

using RacketReference = Reference<RacketContacts, Eigen::Vector3d>;

}  // namespace bounce
