// The progress of a long run, on a terminal of the test's own (a pseudo-terminal); Ctrl-C; memory.

#include "run/progress.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "run_program.hpp"
#include "sanitizers.hpp"

extern char** environ;

using namespace bounce;
using test::contains;

namespace {

/// False, and said, on a system that has no pseudo-terminals (a bare chroot).
bool has_terminals() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) MESSAGE("skipped: this system has no pseudo-terminals (is /dev/pts mounted?)");
  if (terminal >= 0) close(terminal);
  return terminal >= 0;
}

/// A stage's program with a terminal as its standard error, and nothing as its standard output.
class OnTerminal {
 public:
  explicit OnTerminal(const std::string& command) : terminal_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0) std::abort();
    const char* there = ptsname(terminal_);
    // Kept open here as well: a terminal without anybody on it drops what was written.
    held_ = open(there, O_RDWR | O_NOCTTY);
    const std::string line = "exec " + test::quoted(BOUNCE_BIN_DIR) + "/" + command + " 2> '" +
                             there + "' > /dev/null < /dev/null";
    std::vector<std::string> words{"/bin/sh", "-c", line};
    std::vector<char*> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    if (posix_spawn(&child_, "/bin/sh", nullptr, nullptr, arguments.data(), environ) != 0) {
      std::abort();
    }
  }
  ~OnTerminal() {
    close(held_);
    close(terminal_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  /// Reads until `text` has been seen; false after 30 s without it.
  bool wait_for(const std::string& text) {
    return read_until([&] { return contains(seen_, text); });
  }
  void interrupt() { kill(child_, SIGINT); }
  /// Waits for the end, reading on: nobody can write to a full terminal. Returns the exit code.
  int finish() {
    int status = 0;
    const auto ended = [&] { return wait4(child_, &status, WNOHANG, &used_) == child_; };
    if (!read_until(ended)) {
      kill(child_, SIGKILL);
      waitpid(child_, &status, 0);
    }
    if (write(held_, "END", 3) == 3) wait_for("END");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// Of memory [kB], after the end.
  long peak() const { return used_.ru_maxrss; }
  const std::string& seen() const { return seen_; }

 private:
  template <class Condition>
  bool read_until(const Condition& condition) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point latest = Clock::now() + std::chrono::seconds(30);
    while (!condition()) {
      if (Clock::now() > latest) return false;
      pollfd ready{terminal_, POLLIN, 0};
      if (poll(&ready, 1, 20) <= 0) continue;
      char letters[4096];
      const ssize_t count = read(terminal_, letters, sizeof letters);
      if (count <= 0) return false;
      seen_.append(letters, static_cast<std::size_t>(count));
    }
    return true;
  }

  int terminal_, held_;
  pid_t child_ = 0;
  rusage used_{};
  std::string seen_;
};

// Hours of work each, in whatever build.
const std::string long_runs[] = {
    "01_free_fall --headless --dt 1e-9 --duration 100",
    "02_spring_floor --headless --dt 1e-9 --duration 100 --method rk4-events",
    "03_damping --headless --dt 1e-9 --duration 100",
    "04_three_dimensions --headless --dt 1e-9 --duration 100 --method velocity-verlet",
    "05_ball_collision --headless --dt 1e-9 --duration 100 --set scene=drop",
    "06_oscillating_floor --headless --dt 1e-9 --duration 100 --csv /dev/null --sample 1e-5",
    "07_tilted_plane --headless --dt 1e-9 --duration 100 --method rk4",
    "08_racket_game --headless --dt 1e-9 --duration 100 --player autopilot"};

}  // namespace

TEST_CASE(
    "a long run of every stage shows its progress on the terminal, and Ctrl-C takes it away") {
  if (!has_terminals()) return;
  std::vector<std::unique_ptr<OnTerminal>> runs;
  for (const std::string& command : long_runs)
    runs.push_back(std::make_unique<OnTerminal>(command));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    OnTerminal& run = *runs[i];
    const bool shown = run.wait_for(" steps");
    run.interrupt();
    const int code = run.finish();
    INFO(long_runs[i]);
    INFO(run.seen());
    CHECK(shown);
    CHECK(code == 130);
    for (const char* part : {"\r\x1b[K0 %, ", " left, t = ", " of 100 s, ", " steps"}) {
      INFO(part);
      CHECK(contains(run.seen(), part));
    }
    // The line's last trace is its removal: what follows is the summary line and the last word.
    const std::string rest = run.seen().substr(run.seen().rfind("\r\x1b[K") + 4);
    const std::string stage = long_runs[i].substr(0, long_runs[i].find(' '));
    CHECK(rest.rfind(stage + ": method=", 0) == 0);
    CHECK(contains(rest, " interrupted=yes\r\n" + stage + ": interrupted at t = "));
  }
}

TEST_CASE("a short run shows no progress") {
  if (!has_terminals()) return;
  OnTerminal run("03_damping --headless --duration 1");
  CHECK(run.finish() == 0);
  INFO(run.seen());
  CHECK(!contains(run.seen(), "\x1b"));
  CHECK(run.seen().rfind("03_damping: method=", 0) == 0);
}

TEST_CASE("a long run is quiet where standard error is no terminal") {
  const test::Outcome run = test::run_program_with(
      "timeout --preserve-status -s INT 0.8", "03_damping --headless --dt 1e-9 --duration 100");
  CHECK(run.code == 130);
  CHECK(!contains(run.err, "\r"));
  CHECK(!contains(run.err, " left, "));
}

TEST_CASE("the progress says steps, time, rate and what is left, and fits the terminal") {
  const Progress progress{0, 4, 10, 40000000, 8};
  CHECK(progress_line(progress, 100) ==
        "40 %, 12 s left, t = 4 of 10 s, 4e+07 steps, 5e+06 steps/s");
  CHECK(contains(progress_line({0, 1, 61, 100, 10}, 200), "10 min 0 s left"));
  CHECK(contains(progress_line({0, 1, 1001, 100, 10}, 200), "2 h 46 min left"));
  CHECK(contains(progress_line({0, 1e-9, 100, 100, 10}, 200), "more than a year left"));
  CHECK(contains(progress_line({2, 4, 6, 100, 10}, 200), "50 %"));  // a run that was loaded at 2 s
  for (int width = 0; width < 120; ++width) {
    for (const double now : {0.0, 1e-12, 4.0, 10.0, 11.0}) {
      CHECK(progress_line({0, now, 10, 123456789, 77}, width).size() <=
            static_cast<std::size_t>(width));
    }
  }
}

TEST_CASE("memory does not grow with the number of steps") {
  if (test::is_sanitized) {
    MESSAGE("skipped: the address sanitizer keeps what was freed");
    return;
  }
  if (!has_terminals()) return;
  const auto peak = [](const std::string& duration) {
    OnTerminal run("05_ball_collision --headless --set scene=drop --csv /dev/null --sample 1e-3 " +
                   duration);
    CHECK(run.finish() == 0);
    return run.peak();
  };
  const long few = peak("--duration 0.2");
  const long many = peak("--duration 2");
  CAPTURE(few);
  CAPTURE(many);
  // 1800 more rows of 300 balls, kept, would be 30 MB; a megabyte is what the allocator may vary.
  CHECK(many <= few + 1000);
}
