#pragma once
namespace bounce {

/// A method that walks from event to event (events/event_driven.hpp), in place of stepping.
template <class Walk>
struct EventMethod {
  template <class Ball>
  double go_towards(double t, long long most_events, Ball& ball) {
    const double reached = walk.reach(t, most_events) ? t : walk.last_event();
    ball = walk.at(reached);
    return reached;
  }
  double next_event() const { return walk.next_event(); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    self.walk.remembered(self.walk, visit);
  }
  void resume() { walk.resume(); }

  Walk walk;
};

}  // namespace bounce
