// What the playback remembers: the trace for the pictures, and copies of the run to go back to.
#include <algorithm>

#include "app/playback.hpp"

namespace bounce {
namespace {

constexpr std::size_t trace_length = 60 * 240;
constexpr std::size_t past_length = 60 * 60;
// With many balls less is remembered: so many numbers of the trace, and of the copies for
// scrubbing.
constexpr std::size_t trace_numbers = 4'000'000, past_numbers = 4'000'000;

}  // namespace

/// A copy of the run as it is now; the oldest ones are dropped.
void Playback::keep_copy() {
  past_.push_back(simulation_->clone());
  const std::size_t copies = past_numbers / trace_.back().values.size();
  while (past_.size() > std::clamp<std::size_t>(copies, 10, past_length)) past_.pop_front();
}

void Playback::remember() {
  trace_.push_back(trace_point(*simulation_));
  if (trace_.size() > trace_length) trace_.pop_front();
  // Older points keep time and energy for the plots, but no positions.
  const std::size_t with_values =
      std::max<std::size_t>(100, trace_numbers / trace_.back().values.size());
  if (trace_.size() > with_values) {
    std::vector<double>().swap(trace_[trace_.size() - 1 - with_values].values);
  }
}

void Playback::forget_after(double t) {
  while (!trace_.empty() && trace_.back().t > t) trace_.pop_back();
  while (!past_.empty() && past_.back()->time() >= t) past_.pop_back();
}

void Playback::step_back() {
  paused = true;
  // The last copy before now, and from there forward again: the same steps give the same bits.
  const double target = simulation_->time() - simulation_->dt();
  if (target < earliest() - 1e-9 * simulation_->dt()) return;
  go_back_to(target);
}

double Playback::earliest() const {
  return past_.empty() ? simulation_->time() : past_.front()->time();
}

const Simulation* Playback::past(double t) const {
  for (auto copy = past_.rbegin(); copy != past_.rend(); ++copy) {
    if ((*copy)->time() <= t) return copy->get();
  }
  return past_.empty() ? nullptr : past_.front().get();
}

void Playback::go_back_to(double t) {
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

void Playback::restart() {
  trouble_.clear();
  refused_ = false;
  trace_.clear();
  past_.clear();
  simulation_->restart();
  shown_time_ = 0;
  remember();
}

/// A step was not allowed (the balls came too close together), and may have been taken by half:
/// back to the last whole state, and a sentence.
void Playback::refuse(const std::string& why) {
  if (!past_.empty()) {
    simulation_ = past_.back()->clone();
    forget_after(simulation_->time());
    if (trace_.empty() || trace_.back().values.empty()) remember();
    shown_time_ = simulation_->time();
  }
  trouble_ = "It stops soon after t = " + to_rounded_text(simulation_->time()) + " s: " + why;
  refused_ = true;
}

}  // namespace bounce
