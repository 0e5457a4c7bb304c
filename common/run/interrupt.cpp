#include "run/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace bounce {
namespace {

volatile std::sig_atomic_t caught = 0;
extern "C" void on_signal(int) { caught = 1; }

}  // namespace

void catch_interrupts() {
#ifdef _WIN32
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
#else
  struct sigaction action {};
  action.sa_handler = on_signal;  // without SA_RESTART: a write that waits for its reader ends, too
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
#endif
}

bool interrupted() { return caught != 0; }

}  // namespace bounce
