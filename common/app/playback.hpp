#pragma once
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/trace_point.hpp"
#include "run/simulation.hpp"

namespace bounce {

/// Plays a simulation on a clock: runs, pauses, steps, goes back, slows down. It knows no window.
/// The physics always moves by whole steps of its own dt; only the clock is slowed or stopped. One
/// frame takes in at most 0.1 s of real time, so that a stall cannot make it explode or jump, and
/// computes for `budget` at most, so that the picture does not freeze: then time runs slower.
class Playback {
 public:
  using Clock = std::function<double()>;  // s, from any zero
  explicit Playback(std::unique_ptr<Simulation> simulation, Clock clock = wall_clock);
  static double wall_clock();  // of this machine: it never goes back

  Simulation& simulation() { return *simulation_; }
  const Simulation& simulation() const { return *simulation_; }

  /// Moves on by `real_seconds` of the clock.
  void frame(double real_seconds);

  bool paused = false;
  double rate = 1;            // simulated seconds per second of the clock
  bool contact_lens = false;  // slow down in contact, so that it lasts about a second
  double current_rate() const { return current_rate_; }  // with the lens
  double budget = frame_budget;  // of computing in one frame [s]; infinite where nobody waits
  static constexpr double frame_budget = 0.012;
  /// Seconds of the clock that went by for each one that was asked for, over the last half second
  /// or so: 1, or less when computing is slower than the clock.
  double pace() const { return pace_; }

  void step_forward();  // one step; pauses
  void step_back();     // one step; pauses
  void restart();
  void go_back_to(double t);  // to a moment that is still remembered
  double earliest() const;    // [s]
  /// The run as it was at `t` or before, or as early as it is remembered; nullptr where it is not.
  const Simulation* past(double t) const;

  /// Changes parameters, method or state in the middle of the run, or restarts when asked to.
  void change(const std::function<void(Simulation&)>& edit, bool start_anew = false);

  /// Where the picture stands [s]: between the last two steps, so that slow motion is smooth.
  double shown_time() const { return shown_time_; }
  /// Values at the shown time, on the straight line between the last two steps.
  std::vector<double> shown_values() const;

  const std::deque<TracePoint>& trace() const { return trace_; }  // the last minute or so

  /// What would happen from here, `seconds` ahead, with the present parameters. For a ball at rest:
  /// from a new start, as if that were now.
  std::vector<TracePoint> future(double seconds) const;

  /// Not empty when the run had to stop: a sentence for the screen.
  const std::string& trouble() const { return trouble_; }
  /// Whether it stopped because a step was asked for that is not allowed (a BadInput).
  bool is_refused() const { return refused_; }

 private:
  bool is_at_rest() const;  // nothing to see for half a second
  bool in_contact() const { return simulation_->energy().spring > 0; }
  double advance_pieces(double wanted);
  void note_pace(double wanted, double done);
  void move_to(double t);
  void advance_steps_to(double t);
  void refuse(const std::string& why);
  void keep_copy();
  void remember();
  void forget_after(double t);

  std::unique_ptr<Simulation> simulation_;
  std::deque<TracePoint> trace_;
  std::deque<std::unique_ptr<Simulation>> past_;  // one copy a frame
  double shown_time_ = 0;
  double current_rate_ = 1;
  Clock clock_;
  double deadline_ = std::numeric_limits<double>::infinity();  // of the frame, on the clock [s]
  double pace_ = 1;
  std::string trouble_;
  bool refused_ = false;
};

}  // namespace bounce
