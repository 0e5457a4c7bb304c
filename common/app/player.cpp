#include "app/player.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "physics/events/event_driven.hpp"
#include "run/headless.hpp"

namespace bounce {
namespace {

constexpr double trace_interval = 1.0 / 240;  // s between trace points, unless a step is longer
constexpr double longest_frame = 0.1;         // s of the clock that one frame may catch up
constexpr double pace_time = 0.5;             // s over which the pace is a mean
constexpr std::size_t trace_length = 60 * 240;
constexpr std::size_t past_length = 60 * 60;
// With many balls less is remembered: so many numbers of the trace, and of the copies for
// scrubbing.
constexpr std::size_t trace_numbers = 4'000'000, past_numbers = 4'000'000;
constexpr double lens_contact_time = 1.0;  // s on the clock that a contact takes in the lens

// Between two looks at the clock: some 0.1 ms of one ball's steps.
constexpr double steps_between_looks = 1000;

}  // namespace

namespace {

double value_in(const std::vector<double>& values, std::string_view columns,
                std::string_view name) {
  const std::vector<std::string> names = split(columns);
  const auto found = std::find(names.begin(), names.end(), name);
  const auto at = static_cast<std::size_t>(found - names.begin());
  return found != names.end() && at < values.size() ? values[at]
                                                    : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double TracePoint::column(std::string_view name) const { return value_in(values, columns, name); }
double TracePoint::exact_column(std::string_view name) const {
  return value_in(exact, columns, name);
}

double Player::wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Player::Player(std::unique_ptr<Simulation> simulation, Clock clock)
    : simulation_(std::move(simulation)), clock_(std::move(clock)) {
  simulation_->keep_energy_book(true);
  simulation_->parameters_changed();  // opens the book
  shown_time_ = simulation_->time();
  remember();
}

TracePoint Player::point(const Simulation& simulation) {
  const EnergyAccount account = simulation.energy_account();
  return {simulation.traits().columns,
          simulation.time(),
          simulation.values(),
          simulation.exact_values(simulation.time()),
          simulation.energy(),
          account.before,
          account.lost};
}

void Player::remember() {
  trace_.push_back(point(*simulation_));
  if (trace_.size() > trace_length) trace_.pop_front();
  // Older points keep time and energy for the plots, but no positions.
  const std::size_t with_values =
      std::max<std::size_t>(100, trace_numbers / trace_.back().values.size());
  if (trace_.size() > with_values) {
    std::vector<double>().swap(trace_[trace_.size() - 1 - with_values].values);
  }
}

void Player::forget_after(double t) {
  while (!trace_.empty() && trace_.back().t > t) trace_.pop_back();
  while (!past_.empty() && past_.back()->time() >= t) past_.pop_back();
}

void Player::frame(double real_seconds) {
  current_rate_ = rate;
  if (paused || !trouble_.empty()) return;
  past_.push_back(simulation_->clone());
  const std::size_t copies = past_numbers / trace_.back().values.size();
  while (past_.size() > std::clamp<std::size_t>(copies, 10, past_length)) past_.pop_front();

  const double wanted = std::min(real_seconds, longest_frame);
  deadline_ = clock_() + budget;
  const double done = advance_pieces(wanted);
  deadline_ = std::numeric_limits<double>::infinity();
  note_pace(real_seconds, done);
}

/// Moves on by `wanted` seconds of the clock, or until the deadline. Returns how far it came.
double Player::advance_pieces(double wanted) {
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

void Player::note_pace(double wanted, double done) {
  if (!(wanted > 0)) return;
  pace_ += (done / wanted - pace_) * std::min(1.0, wanted / pace_time);
  if (pace_ > 0.99) pace_ = 1;
}

void Player::move_to(double t) {
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
  } catch (const NoClosedForm& error) {
    trouble_ = std::string(error.what()) + " at t = " + to_rounded_text(error.t) + " s.";
  } catch (const BadInput& error) {
    refuse(error.what());
  }
}

/// By whole steps to the first end of one at `t` or after it, or until the deadline. The same steps
/// as in one go, so that the results are the same, to the bit.
void Player::advance_steps_to(double t) {
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

/// A step was not allowed (the balls came too close together), and may have been taken by half:
/// back to the last whole state, and a sentence.
void Player::refuse(const std::string& why) {
  if (!past_.empty()) {
    simulation_ = past_.back()->clone();
    forget_after(simulation_->time());
    if (trace_.empty() || trace_.back().values.empty()) remember();
    shown_time_ = simulation_->time();
  }
  trouble_ = "It stops soon after t = " + to_rounded_text(simulation_->time()) + " s: " + why;
  refused_ = true;
}

std::vector<double> Player::shown_values() const {
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

void Player::step_forward() {
  paused = true;
  if (!trouble_.empty()) return;
  past_.push_back(simulation_->clone());
  const bool by_events = simulation_->method().goes_by_events;
  move_to(by_events ? simulation_->time() + simulation_->dt() : simulation_->time_of_next_step());
}

void Player::step_back() {
  paused = true;
  // The last copy before now, and from there forward again: the same steps give the same bits.
  const double target = simulation_->time() - simulation_->dt();
  if (target < earliest() - 1e-9 * simulation_->dt()) return;
  go_back_to(target);
}

double Player::earliest() const {
  return past_.empty() ? simulation_->time() : past_.front()->time();
}

void Player::go_back_to(double t) {
  trouble_.clear();
  refused_ = false;
  const double tolerance = 1e-6 * simulation_->dt();
  while (past_.size() > 1 && past_.back()->time() > t + tolerance) past_.pop_back();
  if (past_.empty()) return;
  simulation_ = past_.back()->clone();
  past_.pop_back();
  forget_after(simulation_->time());
  if (trace_.empty() || trace_.back().t < simulation_->time() || trace_.back().values.empty()) {
    remember();
  }
  shown_time_ = simulation_->time();
  if (past_.empty()) past_.push_back(simulation_->clone());
  if (t > simulation_->time() + tolerance) {
    past_.push_back(simulation_->clone());
    move_to(t);
  }
}

void Player::restart() {
  trouble_.clear();
  refused_ = false;
  trace_.clear();
  past_.clear();
  simulation_->restart();
  shown_time_ = 0;
  remember();
}

void Player::change(const std::function<void(Simulation&)>& edit, bool start_anew) {
  edit(*simulation_);
  if (start_anew) return restart();
  trouble_.clear();
  refused_ = false;
  simulation_->parameters_changed();
}

bool Player::is_at_rest() const {
  const TracePoint& now = trace_.back();
  for (auto point = trace_.rbegin(); point != trace_.rend(); ++point) {
    if (now.t - point->t > 0.5) return true;
    if (point->energy.kinetic > 1e-4 * std::abs(point->before)) return false;
  }
  return false;
}

std::vector<TracePoint> Player::future(double seconds) const {
  const std::unique_ptr<Simulation> ahead = simulation_->clone();
  double later = 0;
  if (is_at_rest()) {
    later = simulation_->time();
    ahead->restart();
  }
  const double end = ahead->time() + seconds;
  std::vector<TracePoint> points;
  try {
    const bool by_events = ahead->method().goes_by_events;
    const double stride = by_events ? trace_interval : std::max(ahead->dt(), trace_interval);
    // About a millisecond for one ball, and with many not much longer.
    const double most_steps = 2e5 / static_cast<double>(ahead->balls());
    const double reach = by_events ? end : std::min(end, ahead->time() + most_steps * ahead->dt());
    const auto begin = std::chrono::steady_clock::now();
    while (ahead->time() < reach && points.size() < 4000) {
      // How long an event takes, nobody knows before: with many balls `reference` is slow.
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
      if (by_events && ahead->balls() > 1 && taken.count() > frame_budget) break;
      points.push_back(point(*ahead));
      points.back().t += later;
      const double whole = std::max(1.0, std::round(stride / ahead->dt()));
      ahead->advance_to(by_events ? ahead->time() + stride
                                  : ahead->time_of_next_step() + (whole - 1) * ahead->dt());
    }
  } catch (const std::exception&) {  // the path ends where the run would
  }
  return points;
}

}  // namespace bounce
