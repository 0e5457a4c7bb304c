#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>

#include "checks/judged_process.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

namespace {

constexpr double patience = 5;                      // s without an answer and without work
constexpr std::size_t lines_kept = 4, width = 160;  // of what the code prints

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
