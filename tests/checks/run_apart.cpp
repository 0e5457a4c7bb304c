#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>

#include "checks/ended.hpp"
#include "checks/listener.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

namespace {

double processor_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Listens until the process has ended. True: it had to be ended because it waits.
bool listen(pid_t process, int from, Listener& listener, int& status) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  double worked = 0;
  for (;;) {
    const bool over = waitpid(process, &status, WNOHANG) == process;
    char bytes[4096];
    pollfd wait{from, POLLIN, 0};
    ssize_t count = 0;
    while (poll(&wait, 1, over ? 0 : 5) > 0 && (count = read(from, bytes, sizeof bytes)) > 0) {
      listener.take(bytes, static_cast<std::size_t>(count));
      last = Clock::now();
      worked = processor_seconds(process);
    }
    if (over) return false;
    if (count == 0 && (wait.revents & POLLHUP)) usleep(1000);  // it closed the pipe, and lives on
    const double silent = std::chrono::duration<double>(Clock::now() - last).count();
    if (silent > patience && processor_seconds(process) - worked < patience / 8) {
      kill(-process, SIGKILL);
      waitpid(process, &status, 0);
      return true;
    }
  }
}

std::string words_for(int status, bool waits) {
  if (waits) return ended::waits;
  if (shared->forked) return ended::forks;
  if (WIFEXITED(status)) return ended::exits(WEXITSTATUS(status));
  switch (WTERMSIG(status)) {
    case SIGXCPU:
      return ended::loops;
    case SIGFPE:
    case SIGILL:
      return ended::divides_by_0;
    case SIGABRT:
      return ended::aborts;
    case SIGSEGV:
    case SIGBUS:
      return shared->stack_overflow ? ended::calls_itself : ended::bad_address;
    default:
      return ended::from_outside(strsignal(WTERMSIG(status)));
  }
}

}  // namespace

Ending run_apart(const std::function<void()>& work,
                 const std::function<void(const Record&)>& heard) {
  void* page =
      mmap(nullptr, sizeof(SharedPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  int ends[2];
  output = std::tmpfile();
  if (page == MAP_FAILED || !output || pipe(ends) != 0) {
    throw std::runtime_error("no pipe, no memory, or no temporary file");
  }
  shared = new (page) SharedPage{};
  enter("what runs before any function: global variables");
  to_judge = ends[1];
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    be_judged(work);
  }
  if (process < 0) throw std::runtime_error("no process for your code");
  setpgid(process, process);
  close(ends[1]);
  Listener listener(heard);
  int status = 0;
  const bool waits = listen(process, ends[0], listener, status);
  kill(-process, SIGKILL);  // whatever else it started
  close(ends[0]);
  return ending_of(listener, words_for(status, waits));
}

}  // namespace bounce::check
