#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "physics/events/cubic.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/methods/dop853.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Walks from event to event where a contact has no closed form: flights by formula, contacts by a
/// method of order 8 that keeps its error within a tolerance, and each step cut where a contact
/// begins or ends. The pieces in between are smooth, so that the order holds.
///
/// The walk does not depend on who looks: a state in the middle of a piece is a shorter step from
/// the piece's start, and changes nothing.
///
/// `Contacts` tells what touches, and how: see the concept of that name in concepts.hpp.
template <class Contacts, class Vector>
class Reference {
 public:
  /// The first step that it tries is `first_step` [s], or 0: what suits the fastest contact.
  Reference(const Contacts& contacts, double t, const State<Vector>& state, double tolerance,
            double first_step = 0)
      : contacts_(contacts),
        tolerance_(tolerance),
        t_(t),
        state_(state),
        step_(first_step > 0 ? first_step : contacts.time_scale()),
        last_event_(t) {
    begin_piece();
  }

  /// Goes on to the last event or step before `t`, over at most so many. Returns whether it got
  /// there.
  bool reach(double t, long long most_pieces) {
    for (; next_end() <= t; --most_pieces) {
      if (most_pieces == 0) return false;
      pass_piece();
    }
    return true;
  }

  /// The state at `t`, which must lie in the current piece.
  State<Vector> at(double t) {
    if (t == t_) return state_;
    if (contacts_.in_flight()) return contacts_.fly(state_, t - t_);
    method_.start_at(contacts_, 0, state_);
    return method_.step(contacts_, 0, t - t_);
  }

  /// When the next event comes [s]; where none is near, how far it looked.
  double next_event() const {
    Reference ahead = *this;
    for (int piece = 0; piece < 1000; ++piece) {
      const double end = ahead.next_end();
      if (ahead.next_->is_event || end == never) return end;
      ahead.pass_piece();
    }
    return ahead.t_;
  }

  double last_event() const { return t_; }  // or the end of the last step [s]
  const Contacts& contacts() const { return contacts_; }
  double tolerance() const { return tolerance_; }
  long long force_evaluations() const { return method_.evaluations(); }
  long long pieces() const { return pieces_; }

  /// What is saved of a run: the piece's start, and who touches. After loading it goes on from
  /// there with `resume`.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit.positive("next_step", self.step_);
    visit("piece_start", self.t_);
    visit("state_at_piece_start", self.state_);
    self.contacts_.remembered(self.contacts_, visit);
  }
  void resume() {
    last_event_ = t_;
    begin_piece();
  }

 private:
  using Watch = typename Contacts::Watch;

  struct Piece {
    double end;
    bool is_event;
    std::optional<Watch> what;  // for an event that ends no flight
    double step_after;          // s
  };

  double next_end() {
    if (!next_) next_ = contacts_.in_flight() ? flight() : contact();
    return next_->end;
  }

  void pass_piece() {
    const double before = t_;
    const bool is_event = next_->is_event;
    t_ = next_->end;
    step_ = next_->step_after;
    if (contacts_.in_flight()) {
      state_ = contacts_.fly(state_, flight_time_);
      contacts_.land(t_, state_);
    } else {
      state_ = after_;
      if (next_->what) contacts_.pass(*next_->what, t_, state_);
    }
    const bool advances = t_ - before > shortest_step();
    const bool goes_on = advances && t_ - last_event_ > too_short(contacts_, t_);
    if (goes_on) {
      crowded_ = 0;
    } else if (is_event || !advances) {
      ++crowded_;
    }
    if (is_event) last_event_ = t_;
    if (crowded_ > 1000 + 10 * static_cast<long long>(watched_.size())) throw TimeStandsStill(t_);
    begin_piece();
    ++pieces_;
  }

  void begin_piece() {
    if constexpr (requires { contacts_.begin(t_); }) contacts_.begin(t_);
    next_.reset();
  }

  Piece flight() {
    flight_time_ = contacts_.flight_time(t_, state_);
    return {t_ + flight_time_, true, std::nullopt, step_};
  }

  // ---- In contact

  /// What is watched, and its value at the piece's start.
  struct Watched {
    Watch what;
    Lasting before;
    Look look;
  };

  Piece contact() {
    method_.start_at(contacts_, 0, state_);
    watched_.clear();
    for (const Watch& what : contacts_.watches(state_, step_)) {
      Lasting before = contacts_.lasts(what, 0, state_, method_.acceleration_at_start());
      const double rounding = contacts_.rounding(what, state_);
      if (before.value <= -rounding && before.slope < 0) {  // together with the event before
        after_ = state_;
        return {t_, true, what, step_};
      }
      before.value = std::max(before.value, 0.0);  // an event's rounding
      watched_.push_back({what, before, Look::lasts});
    }
    double h = accurate_step();
    const Watched* event = cut_at_first_event(h);
    return {t_ + h, event != nullptr, event ? std::optional(event->what) : std::nullopt,
            step_after_};
  }

  static constexpr bool law_jumps = requires { Contacts::jumps_without_event; };

  double shortest_step() const { return 4 * std::numeric_limits<double>::epsilon() * t_; }

  /// A step whose error is within the tolerance; `after_` is its end. Where a law may jump without
  /// an event (two balls run through each other, centre through centre), the shortest step has to
  /// do. Elsewhere nothing can be said of an error that such a step does not make small.
  double accurate_step() {
    double h = step_;
    bool shortened = false;
    while (true) {
      after_ = method_.step(contacts_, 0, h);
      const double error = method_.error(h, tolerance_);
      step_after_ = error > 0 ? Dop853<Vector>::better_step(h, error) : 6 * h;
      if (error <= 1) break;
      if (!(h > shortest_step())) {
        if (law_jumps && std::isfinite(error)) break;
        throw TimeStandsStill(t_);
      }
      h = std::min(step_after_, 0.9 * h);
      shortened = true;
    }
    if (shortened) step_after_ = std::min(step_after_, h);
    return h;
  }

  /// Shortens the step `h` until at most one thing happens in it, at its very end: the one that is
  /// returned.
  const Watched* cut_at_first_event(double& h) {
    const Watched* event = nullptr;
    while (true) {
      const Vector acceleration = acceleration_after(h);
      Watched* ends = nullptr;
      bool unclear = !contacts_.resolves(state_, after_, h);
      for (Watched& watched : watched_) {
        if (&watched == event) continue;
        const Lasting now = contacts_.lasts(watched.what, h, after_, acceleration);
        watched.look = look(watched.before, now, h, contacts_.rounding(watched.what, after_));
        unclear = unclear || watched.look == Look::unclear;
        if (watched.look == Look::ends && !ends) ends = &watched;
      }
      if (unclear && h / 2 > shortest_step()) {
        step_after_ = std::min(step_after_, h);
        h /= 2;
        event = nullptr;
        after_ = method_.step(contacts_, 0, h);
        continue;
      }
      if (!ends) return event;
      const double before = h;
      h = cut(*ends, h);
      const bool simultaneous = event && before - h <= shortest_step();
      event = ends;
      if (simultaneous) return event;
    }
  }

  Vector acceleration_after(double h) { return contacts_.acceleration(h, after_); }

  /// Newton's method on the length of the step: it ends where `watched` does. Returns the length.
  double cut(const Watched& watched, double h) {
    const Lasting end = contacts_.lasts(watched.what, h, after_, acceleration_after(h));
    double low = 0, high = h;
    double length = Cubic(watched.before, end, h).zero();
    for (int i = 0; i < 60; ++i) {
      after_ = method_.step(contacts_, 0, length);
      const Vector acceleration = acceleration_after(length);
      const Lasting now = contacts_.lasts(watched.what, length, after_, acceleration);
      (now.value > 0 ? low : high) = length;
      double next = (low + high) / 2;
      if (now.slope < 0) {
        const double newton = length - now.value / now.slope;
        if (low <= newton && newton <= high) next = newton;
      }
      const double rest = next - length;
      if (std::abs(rest) <= std::max(1e-7 * h, shortest_step())) {
        // So little that two terms of Taylor's series go the rest of the way.
        after_.position += (after_.velocity + acceleration * (rest / 2)) * rest;
        after_.velocity += acceleration * rest;
        return next;
      }
      length = next;
    }
    return length;
  }

  Contacts contacts_;
  double tolerance_;
  double t_;  // the current piece begins
  State<Vector> state_;
  double step_;  // s: what the error control proposes for the next step
  long long pieces_ = 0;
  double last_event_;      // s
  long long crowded_ = 0;  // events in a row that did not advance time

  // The piece from there, once it is known
  std::optional<Piece> next_;
  double flight_time_ = 0;
  State<Vector> after_{};  // its end
  double step_after_ = 0;
  std::vector<Watched> watched_;
  Dop853<Vector> method_;
};

}  // namespace bounce
