#include "app/playback.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "physics/events/event_driven.hpp"
#include "run/step_warning.hpp"

namespace bounce {
namespace {

constexpr double longest_frame = 0.1;      // s of the clock that one frame may catch up
constexpr double pace_time = 0.5;          // s over which the pace is a mean
constexpr double lens_contact_time = 1.0;  // s on the clock that a contact takes in the lens

// Between two looks at the clock: some 0.1 ms of one ball's steps.
constexpr double steps_between_looks = 1000;

}  // namespace

double Playback::wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Playback::Playback(std::unique_ptr<Simulation> simulation, Clock clock)
    : simulation_(std::move(simulation)), clock_(std::move(clock)) {
  simulation_->keep_energy_book(true);
  simulation_->parameters_changed();  // opens the book
  shown_time_ = simulation_->time();
  remember();
}

void Playback::frame(double real_seconds) {
  current_rate_ = rate;
  if (paused || !trouble_.empty()) return;
  keep_copy();

  const double wanted = std::min(real_seconds, longest_frame);
  deadline_ = clock_() + budget;
  const double done = advance_pieces(wanted);
  deadline_ = std::numeric_limits<double>::infinity();
  note_pace(real_seconds, done);
}

/// Moves on by `wanted` seconds of the clock, or until the deadline. Returns how far it came.
double Playback::advance_pieces(double wanted) {
  double left = wanted;
  while (left > 0 && trouble_.empty()) {
    const std::optional<ContactNumbers> contact = simulation_->contact();
    const bool slow = contact_lens && contact && in_contact();
    current_rate_ = rate;
    if (slow) {
      const double contact_time = std::numbers::pi / contact->omega0;
      current_rate_ = std::min(rate, contact_time / lens_contact_time);
    }
    double piece = std::min(left, trace_interval / std::max(1.0, current_rate_));
    // With the lens on, come close to a touch in small pieces, not to jump through half of it.
    if (contact_lens && contact) piece = std::min(piece, 1e-3);
    const double before = shown_time_;
    move_to(before + piece * current_rate_);
    if (clock_() > deadline_) {
      return wanted - left + std::min(piece, (shown_time_ - before) / current_rate_);
    }
    left -= piece;
  }
  return wanted;
}

void Playback::note_pace(double wanted, double done) {
  if (!(wanted > 0)) return;
  pace_ += (done / wanted - pace_) * std::min(1.0, wanted / pace_time);
  if (pace_ > 0.99) pace_ = 1;
}

void Playback::move_to(double t) {
  try {
    if (simulation_->method().goes_by_events) {
      simulation_->advance_to(t);
      remember();
      shown_time_ = t;
    } else {
      if (simulation_->time() < t) {
        advance_steps_to(t);
        remember();
      }
      // Unless the deadline came first.
      const bool is_there = simulation_->time() > t - 1e-6 * simulation_->dt();
      shown_time_ = is_there ? t : simulation_->time();
    }
  } catch (const NonFinite& error) {
    trouble_ = "The state became infinite at t = " + to_rounded_text(error.t) + " s. " +
               step_warning(*simulation_);
  } catch (const TimeStandsStill& error) {
    trouble_ = std::string(error.what()) + " at t = " + to_rounded_text(error.t) + " s.";
  } catch (const BadInput& error) {
    refuse(error.what());
  }
}

/// By whole steps to the first end of one at `t` or after it, or until the deadline. The same steps
/// as in one go, so that the results are the same, to the bit.
void Playback::advance_steps_to(double t) {
  const double dt = simulation_->dt();
  const Traits its = simulation_->traits();
  const double each = static_cast<double>(its.balls) * its.pieces_per_step;
  const double portion = std::max(1.0, std::floor(steps_between_looks / each));
  double left = std::ceil((t - simulation_->time()) / dt - 1e-9);
  do {
    const double steps = std::min(left, portion);
    simulation_->advance_to(simulation_->time_of_next_step() + std::max(0.0, steps - 1) * dt);
    left -= steps;
  } while (left > 0 && clock_() <= deadline_);
}

std::vector<double> Playback::shown_values() const {
  std::vector<double> values = trace_.back().values;
  if (trace_.size() < 2) return values;
  const TracePoint& before = trace_[trace_.size() - 2];
  const TracePoint& after = trace_.back();
  const double span = after.t - before.t;
  if (!(span > 0) || shown_time_ >= after.t || before.values.empty()) return values;
  const double share = std::clamp((shown_time_ - before.t) / span, 0.0, 1.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = before.values[i] + share * (after.values[i] - before.values[i]);
  }
  return values;
}

void Playback::step_forward() {
  paused = true;
  if (!trouble_.empty()) return;
  past_.push_back(simulation_->clone());
  const bool by_events = simulation_->method().goes_by_events;
  move_to(by_events ? simulation_->time() + simulation_->dt() : simulation_->time_of_next_step());
}

void Playback::change(const std::function<void(Simulation&)>& edit, bool start_anew) {
  edit(*simulation_);
  if (start_anew) return restart();
  trouble_.clear();
  refused_ = false;
  simulation_->parameters_changed();
  // It is seen at once, also while time stands still; and a ball that was put somewhere is there.
  if (simulation_->values() != trace_.back().values) shown_time_ = simulation_->time();
  if (trace_.back().t == simulation_->time()) trace_.pop_back();
  remember();
}

}  // namespace bounce
