#pragma once
#include <chrono>
#include <string>

#include "run/simulation.hpp"

namespace bounce {

/// How far a run is.
struct Progress {
  double start, now, end;  // simulated time [s]
  long long steps;         // since `start`
  double wall;             // s on the clock since `start`
};

/// "40 %, 4 s left, t = 4.1 of 10 s, 4.1e+07 steps, 3.1e+08 steps/s", and of that what fits into
/// `width` letters.
std::string progress_line(const Progress& progress, int width);

/// The line on the terminal during a long run. It first appears after half a second, and nothing is
/// left of it when the run ends, however it ends. Where standard error is no terminal, or where the
/// trace goes to the same one, there is no such line.
class ProgressLine {
 public:
  ProgressLine(const Simulation& simulation, double end, bool trace_on_output);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To be called as often as one likes: it draws at most ten times a second.
  void show(const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  bool drawn_ = false;
  double start_, end_;  // s, simulated
  long long steps_at_start_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_ + std::chrono::milliseconds(500);
};

}  // namespace bounce
