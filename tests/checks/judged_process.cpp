#include "checks/judged_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "sanitizers.hpp"

namespace bounce::check {

namespace {

constexpr rlim_t seconds_a_check = 3;               // of processor time; a check takes 0.1 s
constexpr rlim_t most_memory = rlim_t{1} << 30;     // bytes
constexpr rlim_t stack_size = rlim_t{8} << 20;      // bytes
constexpr rlim_t most_output = rlim_t{16} << 20;    // bytes
constexpr double patience = 5;                      // s without an answer and without work
constexpr std::size_t lines_kept = 4, width = 160;  // of what the code prints

/// Seen by both processes: who dies cannot speak.
struct Shared {
  char function[64];
  bool stack_overflow, read_input, forked;
};
Shared* shared = nullptr;
int to_judge = -1;
FILE* output = nullptr;
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

void not_caught() {
  end_with(
      "a thread or a noexcept function let an exception out, or a std::thread was neither joined "
      "nor detached");
}

void prepare_judged_process() {
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

[[noreturn]] void judged(const std::function<void()>& work) {
  prepare_judged_process();
  work();
  std::cout.flush();
  std::fflush(nullptr);
  _exit(0);
}

double processor_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Cuts what came over the pipe into records, and hands them on.
class Listener {
 public:
  explicit Listener(const std::function<void(const Record&)>& heard) : heard_(heard) {}
  std::string ended_with;
  bool all_ran = false;

  void take(const char* bytes, std::size_t count) {
    for (const char c : std::string(bytes, count)) {
      if (c == '\0') {
        record_.push_back(word_), word_.clear();
      } else if (c == '\1') {
        finish(record_);
        record_.clear();
      } else {
        word_ += c;
      }
    }
  }

 private:
  void finish(const Record& record) {
    if (record.size() == 2 && record[0] == "ended") {
      ended_with = record[1];
    } else if (record.size() == 1 && record[0] == "all checks ran") {
      all_ran = true;
    } else {
      heard_(record);
    }
  }
  const std::function<void(const Record&)>& heard_;
  Record record_;
  std::string word_;
};

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
  if (waits) {
    return "your code waits for something that does not come: an input, a sleep, or a lock. "
           "Nobody types here";
  }
  if (shared->forked) return "your code calls fork(): it must start no other process";
  if (WIFEXITED(status)) {
    return "your code ended the whole program, with exit(" + std::to_string(WEXITSTATUS(status)) +
           ") or the like. A function ends with return";
  }
  switch (WTERMSIG(status)) {
    case SIGXCPU:
      return "your code does not come back: is there a loop that never ends?";
    case SIGFPE:
    case SIGILL:
      return "your code divided a whole number by 0";
    case SIGABRT:
      return "your code stopped itself: an assert that is not true, an index outside of a vector, "
             "or abort()";
    case SIGSEGV:
    case SIGBUS:
      return shared->stack_overflow
                 ? "a function calls itself again and again, without end, until the memory for "
                   "calls is full"
                 : "your code uses memory that is not its own: an index outside of an array, or a "
                   "pointer to nothing";
    default:
      return std::string("your code was ended from outside (") + strsignal(WTERMSIG(status)) + ")";
  }
}

void read_output(Ending& ending) {
  std::rewind(output);
  std::string line;
  for (int c = std::fgetc(output); c != EOF || !line.empty(); c = std::fgetc(output)) {
    if (c != '\n' && c != EOF) {
      if (line.size() < 2 * width) line += std::iscntrl(c) ? '?' : static_cast<char>(c);
      continue;
    }
    const std::size_t mine = line.find("mine.hpp:");  // an assert says where it stands
    if (mine != std::string::npos) line.erase(0, mine);
    if (ending.printed.size() < lines_kept) ending.printed.push_back(line.substr(0, width));
    line.clear();
    ++ending.lines;
  }
}

}  // namespace

void tell(const Record& record) {
  std::string text;
  for (const std::string& word : record) text += word + '\0';
  text += '\1';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t now = write(to_judge, text.data() + sent, text.size() - sent);
    if (now <= 0) _exit(1);
    sent += static_cast<std::size_t>(now);
  }
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

void enter(const char* function) {
  if (shared) std::strncpy(shared->function, function, sizeof shared->function - 1);
}

void end_with(const std::string& words) {
  tell({"ended", words});
  _exit(1);
}

void end_without_memory() {
  limit(RLIMIT_AS, RLIM_INFINITY);  // to speak needs some
  end_with(
      "your code asks for more memory than there is: is there a vector that grows without end?");
}

bool has_printed() {
  std::cout.flush();
  std::fflush(nullptr);
  struct stat file {};
  return fstat(STDOUT_FILENO, &file) == 0 && file.st_size > 0;
}

Ending run_apart(const std::function<void()>& work,
                 const std::function<void(const Record&)>& heard) {
  const char here = 0;
  stack_top = &here;
  void* page =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  int ends[2];
  output = std::tmpfile();
  if (page == MAP_FAILED || !output || pipe(ends) != 0) {
    throw std::runtime_error("no pipe, no memory, or no temporary file");
  }
  shared = new (page) Shared{};
  enter("what runs before any function: global variables");
  to_judge = ends[1];
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    judged(work);
  }
  if (process < 0) throw std::runtime_error("no process for your code");
  setpgid(process, process);
  close(ends[1]);
  Listener listener(heard);
  int status = 0;
  const bool waits = listen(process, ends[0], listener, status);
  kill(-process, SIGKILL);  // whatever else it started
  close(ends[0]);
  Ending ending;
  if (!listener.all_ran) {
    ending.words = listener.ended_with.empty() ? words_for(status, waits) : listener.ended_with;
  }
  ending.where = shared->function;
  ending.read_input = shared->read_input;
  read_output(ending);
  std::fclose(output);
  return ending;
}

}  // namespace bounce::check
