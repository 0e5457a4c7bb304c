#pragma once

#include "08_racket_game/exact/exact.hpp"
#include "physics/events/event_driven.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// A ball as it is seen from a disc that does not turn, and back as it is seen from the ground.
inline State<Eigen::Vector3d> seen_from(const Disc& disc, const State<Eigen::Vector3d>& ball) {
  return {ball.position - disc.centre, ball.velocity - disc.velocity};
}
inline State<Eigen::Vector3d> from_ground(const Disc& disc, const State<Eigen::Vector3d>& seen) {
  return {seen.position + disc.centre, seen.velocity + disc.velocity};
}

/// A ball and a racket in uniform motion, from event to event. The walk is done in the racket's
/// frame of reference, where the racket rests; nothing in a contact depends on who watches.
class RacketWalk {
 public:
  using Ball = State<Eigen::Vector3d>;

  /// `scene.disc` is the racket at time `scene.since`.
  RacketWalk(const Racket& scene, double t, const Ball& ball)
      : scene_(scene), walker_(RacketExact(scene), t, seen_from(scene.disc_at(t), ball)) {}

  /// Passes the events up to `t`, but at most so many. Returns whether it got there.
  bool reach(double t, long long most_events) {
    for (; next_event() <= t; --most_events) {
      if (most_events == 0) return false;
      pass_event();
    }
    return true;
  }

  /// The state at `t`, before the next event. Throws NoClosedForm from the moment on at which the
  /// ball meets the rim.
  Ball at(double t) {
    if (meets_rim_before(t))
      throw NoClosedForm(dead_end_,
                         "the ball meets the racket's rim, for which "
                         "there is no closed form,");
    return to_ground(walker_.at(t), t);
  }

  double next_event() const { return dead_end_ < never ? never : walker_.next_event(); }
  double last_event() const { return walker_.last_event(); }
  bool meets_rim_before(double t) const { return t >= dead_end_; }
  Phase phase() const { return walker_.phase(); }
  const Ball& seen_at_last_event() const { return walker_.state_at_last_event(); }

  Ball to_ground(const Ball& seen, double t) const { return from_ground(scene_.disc_at(t), seen); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    self.walker_.remembered(self.walker_, visit);
  }
  void resume() {
    walker_.resume();
    dead_end_ = never;
  }

 private:
  void pass_event() {
    const double when = walker_.next_event();
    try {
      walker_.pass_event();
    } catch (const RimReached&) {
      dead_end_ = when;
    }
  }

  Racket scene_;
  EventDriven<RacketExact, Eigen::Vector3d> walker_;
  double dead_end_ = never;  // when the ball meets the rim, once that is known
};

}  // namespace bounce
