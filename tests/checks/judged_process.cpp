#include "checks/judged_process.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

#include "checks/ended.hpp"
#include "checks/shared_page.hpp"
#include "sanitizers.hpp"

namespace bounce::check {

namespace {

constexpr rlim_t seconds_a_check = 3;             // of processor time; a check takes 0.1 s
constexpr rlim_t most_memory = rlim_t{1} << 30;   // bytes
constexpr rlim_t stack_size = rlim_t{8} << 20;    // bytes
constexpr rlim_t most_output = rlim_t{16} << 20;  // bytes

const char* stack_top = nullptr;

void limit(int which, rlim_t most) {
  rlimit now{};
  getrlimit(static_cast<decltype(RLIMIT_CPU)>(which), &now);
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(static_cast<decltype(RLIMIT_CPU)>(which), &now);
}

/// Only tells a full stack from another bad address; then the signal does what it always does.
void bad_address(int signal, siginfo_t* info, void*) {
  const char* address = static_cast<const char*>(info->si_addr);
  const auto reach = static_cast<std::ptrdiff_t>(stack_size + (rlim_t{1} << 20));
  shared->stack_overflow = address < stack_top && address > stack_top - reach;
  std::signal(signal, SIG_DFL);
}

void watch_the_stack() {
  static char other_stack[1 << 16];  // a handler cannot run on a stack that is full
  const stack_t stack{other_stack, 0, sizeof other_stack};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_sigaction = bad_address;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
  sigaction(SIGBUS, &action, nullptr);
}

/// Called before each fork(). (A limit on processes does not hold for root.)
void no_fork() {
  shared->forked = true;
  _exit(1);
}

void not_caught() { end_with(ended::not_caught); }

}  // namespace

void prepare_judged_process() {
  const char here = 0;
  stack_top = &here;
  setpgid(0, 0);  // with all that it may start, so that nothing outlives it
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nor the judge, when Ctrl-C ends that
#endif
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  std::fflush(nullptr);
  dup2(fileno(output), STDOUT_FILENO);
  dup2(fileno(output), STDERR_FILENO);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // no line is lost in a crash
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_STACK, stack_size);
  limit(RLIMIT_FSIZE, most_output);
  std::signal(SIGXFSZ, SIG_IGN);  // what is printed beyond that is thrown away
  if (!test::is_sanitized) limit(RLIMIT_AS, most_memory);
  watch_the_stack();
  std::set_terminate(not_caught);
  pthread_atfork(no_fork, nullptr, nullptr);
  begin_question();
}

void begin_question() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1;
  limit(RLIMIT_CPU, static_cast<rlim_t>(seconds) + seconds_a_check);
}

void finish() {
  std::error_code none;
  const std::filesystem::directory_iterator threads("/proc/self/task", none), end;
  if (!none && std::distance(threads, end) > 1) {
    end_with("a thread that your code started is still running when all is answered");
  }
  shared->read_input = !std::cin || std::feof(stdin);
  tell({"all checks ran"});
}

void end_without_memory() {
  limit(RLIMIT_AS, RLIM_INFINITY);  // to speak needs some
  end_with(ended::no_memory);
}

}  // namespace bounce::check
