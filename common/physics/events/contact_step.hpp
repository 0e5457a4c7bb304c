#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "physics/events/cubic.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/dop853.hpp"
#include "physics/methods/dopri5.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The shortest step at `t` that still is one [s].
inline double shortest_step(double t) { return 4 * std::numeric_limits<double>::epsilon() * t; }

/// One step in contact, by a method of order 8 (in a crowd, where events cut it short, of order 5):
/// so long that its error stays within a tolerance, with at most one event, at its very end.
template <class Contacts, class Vector>
class ContactStep {
 public:
  using Event = typename Contacts::Event;

  /// Where the step begins.
  struct Start {
    Contacts& contacts;
    double t;  // s
    const State<Vector>& state;
  };
  struct Taken {
    double length;              // s
    std::optional<Event> what;  // the event at its end, if there is one
    double next;                // s: what the error control proposes for the next step
  };

  explicit ContactStep(double tolerance) : tolerance_(tolerance) {}

  /// Tries a step of `h` first.
  Taken take(const Start& start, double h) {
    method_.start_at(start.contacts, 0, start.state);
    watched_.clear();
    for (const Event& what : start.contacts.events(start.state, h)) {
      EventValue before =
          start.contacts.event_value(what, 0, start.state, method_.acceleration_at_start());
      if (before.value <= 0 && before.slope < 0 &&
          before.value <= -start.contacts.rounding(what, start.state)) {
        // together with the event before
        after_ = start.state;
        return {0, what, h};
      }
      before.value = std::max(before.value, 0.0);  // an event's rounding
      watched_.push_back({what, before, RootInStep::none, top_rate(start, what)});
    }
    const double proposed = h, expected = crowd ? expected_event(start, h) : h;
    h = std::min(h, expected + near_enough(start, expected) / 2);
    is_short_ = crowd && order_5_will_do(start, h);
    if (is_short_) short_.start_at(start.state, method_.acceleration_at_start());
    h = accurate_step(start, h);
    // That events cut this step short says little of the next.
    if (is_short_) step_after_ = std::max(step_after_, proposed / 2);
    const WatchedEvent* event = cut_at_first_event(start, h);
    return {h, event ? std::optional(event->what) : std::nullopt, step_after_};
  }

  /// The state at the end of the step that was taken.
  const State<Vector>& end() const { return after_; }

  /// The state `since` seconds after the start, by a step of its own.
  State<Vector> at(const Start& start, double since) {
    method_.start_at(start.contacts, 0, start.state);
    return method_.step(start.contacts, 0, since);
  }

  std::size_t watched() const { return watched_.size(); }
  long long force_evaluations() const { return method_.evaluations() + short_.evaluations(); }

 private:
  /// What is watched, and its value at the piece's start.
  struct WatchedEvent {
    Event what;
    EventValue before;
    RootInStep root;
    double top_rate;  // per second: its value changes no faster
  };

  static constexpr bool law_jumps = requires { Contacts::jumps_without_event; };
  static constexpr bool crowd = requires { Contacts::is_crowd; };

  static double top_rate(const Start& start, const Event& what) {
    if constexpr (crowd) return start.contacts.top_rate(what);
    return never;
  }

  /// From so near [s] Taylor's series goes the rest of the way to an event: the term that is left
  /// out, h a'' s^2 / 4, is a thousandth of what the tolerance allows.
  double near_enough(const Start& start, double h) const {
    const double fastest = start.contacts.time_scale();
    return crowd ? fastest * std::sqrt(1e-3 * tolerance_ * fastest / h) : 0;
  }

  /// Whether order 5 will do, at half the cost: its error falls as h^5. The estimate has the word.
  bool order_5_will_do(const Start& start, double h) const {
    const double share = h / start.contacts.time_scale();
    return share * share * share * share * share < tolerance_;
  }

  /// In a crowd events come more often than the error control would step. So it is foretold when
  /// the next one comes, if within `h`: the step ends there, and need not be taken twice. A guess,
  /// on which nothing depends but the cost.
  double expected_event(const Start& start, double h) {
    const WatchedEvent* first = nullptr;
    double time = h;
    for (const WatchedEvent& watched : watched_) {
      if (!(watched.before.value < -watched.before.slope * time)) continue;
      if (watched.before.value <= start.contacts.rounding(watched.what, start.state)) continue;
      time = -watched.before.value / watched.before.slope;
      first = &watched;
    }
    const Vector& acceleration = method_.acceleration_at_start();
    for (int i = 0; first && i < 3; ++i) {
      after_.position =
          start.state.position + (start.state.velocity + acceleration * (time / 2)) * time;
      after_.velocity = start.state.velocity + acceleration * time;
      Vector later = acceleration;
      if (i == 2) {  // and with the acceleration's change
        later = start.contacts.acceleration(time, after_);
        after_.position += (later - acceleration) * (time * time / 6);
        after_.velocity += (later - acceleration) * (time / 2);
      }
      const EventValue then = start.contacts.event_value(first->what, time, after_, later);
      const double better = time - then.value / then.slope;
      if (!(then.slope < 0 && better > time / 2 && better < 2 * time)) break;
      time = better;
      if (order_5_will_do(start, time)) break;  // then its acceleration hardly changes
    }
    return first ? time : h;
  }

  /// A step whose error is within the tolerance; `after_` is its end. Where a law may jump without
  /// an event (two balls run through each other, centre through centre), the shortest step has to
  /// do. Elsewhere nothing can be said of an error that such a step does not make small.
  double accurate_step(const Start& start, double h) {
    bool shortened = false;
    while (true) {
      step(start, h);
      const double error = is_short_ ? short_.error(h, tolerance_) : method_.error(h, tolerance_);
      step_after_ = error > 0 && !is_short_ ? Dop853<Vector>::better_step(h, error) : 6 * h;
      if (error <= 1) break;
      if (std::exchange(is_short_, false)) continue;
      if (!(h > shortest_step(start.t))) {
        if (law_jumps && std::isfinite(error)) break;
        throw TimeStandsStill(start.t);
      }
      h = std::min(step_after_, 0.9 * h);
      shortened = true;
    }
    if (shortened) step_after_ = std::min(step_after_, h);
    return h;
  }

  /// Shortens the step `h` until at most one thing happens in it, at its very end: the one that is
  /// returned.
  const WatchedEvent* cut_at_first_event(const Start& start, double& h) {
    const WatchedEvent* event = nullptr;
    while (true) {
      WatchedEvent* ends = nullptr;
      bool unclear = !start.contacts.resolves(start.state, after_, h);
      for (WatchedEvent& watched : watched_) {
        if (&watched == event) continue;
        watched.root = RootInStep::none;
        if (watched.before.value > watched.top_rate * h) continue;
        const EventValue now = value_after(start, watched, h);
        watched.root =
            root_in_step(watched.before, now, h, start.contacts.rounding(watched.what, after_));
        unclear = unclear || watched.root == RootInStep::unclear;
        if (watched.root == RootInStep::one && !ends) ends = &watched;
      }
      if (unclear && h / 2 > shortest_step(start.t)) {
        step_after_ = std::min(step_after_, h);
        h /= 2;
        event = nullptr;
        step(start, h);
        continue;
      }
      if (!ends) return event;
      const double before = h;
      h = cut(start, *ends, h);
      const bool simultaneous = event && before - h <= shortest_step(start.t);
      event = ends;
      if (simultaneous) return event;
    }
  }

  /// Newton's method on the length of the step: it ends where `watched` does. Returns the length.
  double cut(const Start& start, const WatchedEvent& watched, double h) {
    EventValue now = value_after(start, watched, h);
    double low = 0, high = h, length = h;
    const double guess = Cubic(watched.before, now, h).zero();
    const auto shorten = [&](double to) {
      step(start, length = to);
      now = value_after(start, watched, length);
    };
    if (!crowd) shorten(guess);
    for (int i = 0; i < 60; ++i) {
      (now.value > 0 ? low : high) = length;
      double next = (low + high) / 2;
      if (now.slope < 0) {
        const double newton = length - now.value / now.slope;
        if (low <= newton && newton <= high) next = newton;
      }
      const double rest = next - length;
      if (std::abs(rest) <=
          std::max({1e-7 * h, near_enough(start, length), shortest_step(start.t)})) {
        // So little that Taylor's series goes the rest of the way: two terms, in a crowd three.
        const Vector change =
            (acceleration_ - method_.acceleration_at_start()) * (crowd ? rest / length : 0);
        after_.position += (after_.velocity + (acceleration_ + change / 3) * (rest / 2)) * rest;
        after_.velocity += (acceleration_ + change / 2) * rest;
        acceleration_ += change;
        return next;
      }
      shorten(length < h ? next : guess);
    }
    return length;
  }

  void step(const Start& start, double h) {
    after_ = is_short_ ? short_.step(start.contacts, 0, h) : method_.step(start.contacts, 0, h);
    acceleration_ =
        is_short_ ? short_.acceleration_at_end() : start.contacts.acceleration(h, after_);
  }
  EventValue value_after(const Start& start, const WatchedEvent& watched, double h) const {
    return start.contacts.event_value(watched.what, h, after_, acceleration_);
  }

  double tolerance_;
  State<Vector> after_{};  // the end of the step,
  Vector acceleration_{};  // and what it is there
  double step_after_ = 0;
  std::vector<WatchedEvent> watched_;
  Dop853<Vector> method_;
  Dopri5<Vector> short_;   // for short steps, in a crowd
  bool is_short_ = false;  // this one is
};

}  // namespace bounce
