#include "run/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>

#ifdef _WIN32
#include <io.h>
#else
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace bounce {
namespace {

#ifdef _WIN32
bool is_terminal(int file) { return _isatty(file) != 0; }
int terminal_width() { return 80; }
#else
bool is_terminal(int file) { return isatty(file) != 0; }
int terminal_width() {
  winsize size{};
  return ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}
#endif

/// What every terminal but a dumb one understands: to the start of the line, and clear it.
constexpr const char* wipe = "\r\x1b[K";

/// "40 s", "3 min 20 s", "2 h 5 min"
std::string duration_text(double seconds) {
  if (seconds < 59.5) return to_rounded_text(std::round(seconds), 2) + " s";
  const double minutes = std::floor(seconds / 60);
  if (minutes < 60) {
    return to_text(minutes) + " min " + to_text(std::floor(seconds - 60 * minutes)) + " s";
  }
  const double hours = std::floor(minutes / 60);
  if (hours > 9999) return "more than a year";
  return to_text(hours) + " h " + to_text(minutes - 60 * hours) + " min";
}

}  // namespace

std::string progress_line(const Progress& progress, int width) {
  const double share =
      std::clamp((progress.now - progress.start) / (progress.end - progress.start), 0.0, 1.0);
  const auto steps = static_cast<double>(progress.steps);
  const std::string percent = to_text(std::floor(100 * share));
  std::string text = percent + " %, ";
  if (share > 0) text += duration_text(progress.wall * (1 - share) / share) + " left, ";
  text += "t = " + to_rounded_text(progress.now) + " of " + to_rounded_text(progress.end) + " s";
  if (steps > 0) {  // `exact` takes none
    text += ", " + to_rounded_text(steps, 2) + " steps, " +
            to_rounded_text(steps / progress.wall, 2) + " steps/s";
  }
  return text.substr(0, static_cast<std::size_t>(std::max(0, width)));
}

ProgressLine::ProgressLine(const Simulation& simulation, double end, bool trace_on_output)
    : start_(simulation.time()), end_(end), steps_at_start_(simulation.steps()) {
  const char* kind = std::getenv("TERM");
  const bool dumb = kind != nullptr && std::string_view(kind) == "dumb";
  wanted_ = is_terminal(2) && !dumb && !(trace_on_output && is_terminal(1));
}

ProgressLine::~ProgressLine() {
  if (drawn_) std::cerr << wipe << std::flush;
}

void ProgressLine::show(const Simulation& simulation) {
  if (!wanted_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const Progress progress{start_, simulation.time(), end_, simulation.steps() - steps_at_start_,
                          std::chrono::duration<double>(now - begin_).count()};
  // One letter less than the terminal is wide: in the last column some of them begin a new line.
  std::cerr << wipe + progress_line(progress, terminal_width() - 1) << std::flush;
  drawn_ = true;
}

}  // namespace bounce
