#pragma once
#include <optional>

#include "physics/events/contact_step.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Walks from event to event where a contact has no closed form: flights by formula, contacts by a
/// method of order 8 that keeps its error within a tolerance, and each step cut where a contact
/// begins or ends. The pieces in between are smooth, so that the order holds.
///
/// The walk does not depend on who looks: a state in the middle of a piece is a shorter step from
/// the piece's start, and changes nothing.
///
/// `Contacts` tells what touches, and how: see ContactsFor in concepts.hpp.
template <class Contacts, class Vector>
class Reference {
 public:
  /// The first step that it tries is `first_step` [s], or 0: what suits the fastest contact.
  Reference(const Contacts& contacts, double t, const State<Vector>& state, double tolerance,
            double first_step = 0) requires ContactsFor<Contacts, Vector>
      : contacts_(contacts),
        t_(t),
        state_(state),
        step_(first_step > 0 ? first_step : contacts.time_scale()),
        last_event_(t),
        contact_(tolerance) {
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
    return contact_.at({contacts_, t_, state_}, t - t_);
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
  long long force_evaluations() const { return contact_.force_evaluations(); }
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
  using Event = typename Contacts::Event;

  struct Piece {
    double end;
    bool is_event;
    std::optional<Event> what;  // for an event that ends no flight
    double step_after;          // s
  };

  double next_end() {
    if (!next_) next_ = contacts_.in_flight() ? flight() : touch();
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
      state_ = contact_.end();
      if (next_->what) contacts_.pass(*next_->what, t_, state_);
    }
    const bool advances = t_ - before > shortest_step(t_);
    const bool goes_on = advances && t_ - last_event_ > too_short(contacts_, t_);
    if (goes_on) {
      crowded_ = 0;
    } else if (is_event || !advances) {
      ++crowded_;
    }
    if (is_event) last_event_ = t_;
    if (crowded_ > 1000 + 10 * static_cast<long long>(contact_.watched()))
      throw TimeStandsStill(t_);
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
  Piece touch() {
    const auto taken = contact_.take({contacts_, t_, state_}, step_);
    return {t_ + taken.length, taken.what.has_value(), taken.what, taken.next};
  }

  Contacts contacts_;
  double t_;  // the current piece begins
  State<Vector> state_;
  double step_;  // s: what the error control proposes for the next step
  long long pieces_ = 0;
  double last_event_;      // s
  long long crowded_ = 0;  // events in a row that did not advance time

  // The piece from there, once it is known
  std::optional<Piece> next_;
  double flight_time_ = 0;
  ContactStep<Contacts, Vector> contact_;
};

}  // namespace bounce
