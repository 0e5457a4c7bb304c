// tests/main.cpp sets the traps; this asks whether they hold.

#include "floating_point_traps.hpp"

#include <doctest/doctest.h>

#if defined(__GLIBC__) && !defined(__clang__)
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace {

/// The signal that ends a copy of this program when it computes a / b * c; 0: it gets there.
int signal_of(double a, double b, double c) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGFPE, SIG_DFL);  // no report of doctest's or of a sanitizer's
    volatile double x = a, y = b, z = c;
    volatile double result = x / y * z;
    (void)result;
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("hard case: a NaN, a division by zero and an overflow end a test where they happen") {
  CHECK(signal_of(1, 3, 2) == 0);
  CHECK(signal_of(0, 0, 1) == SIGFPE);
  CHECK(signal_of(1, 0, 1) == SIGFPE);
  CHECK(signal_of(1e308, 1, 1e308) == SIGFPE);
  CHECK(signal_of(1e-308, 1, 1e-308) == 0);  // an underflow is none: denormals are numbers
  const bounce::test::WithoutTraps here;
  CHECK(signal_of(0, 0, 1) == 0);
}
#endif
