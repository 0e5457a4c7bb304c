// The judged process on Windows. Its limits on time, memory and output are kept by the judge
// (run_apart.cpp, here). Elsewhere more is told: that a thread is still running, that
// another process was started, and that an exception was not caught (which is an abort() here).
#include "checks/judged_process.hpp"

#include <windows.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <thread>

#include "checks/ended.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

namespace {

/// To be read by the judge: wine tells how long a process worked to that process alone.
void note_work() {
  const auto seconds = [](const FILETIME& time) {
    return 1e-7 * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
  };
  for (FILETIME start, end, kernel, user;; Sleep(20)) {
    GetProcessTimes(GetCurrentProcess(), &start, &end, &kernel, &user);
    shared->worked = seconds(kernel) + seconds(user);
  }
}

/// Ends at once, and with the reason as exit code: without a box that waits for a click, or a
/// debugger.
LONG WINAPI end_at_once(EXCEPTION_POINTERS* why) {
  TerminateProcess(GetCurrentProcess(), why->ExceptionRecord->ExceptionCode);
  return EXCEPTION_EXECUTE_HANDLER;
}

/// First of all: a full stack has no room for what comes before the last handler.
LONG WINAPI end_on_a_full_stack(EXCEPTION_POINTERS* why) {
  const bool full = why->ExceptionRecord->ExceptionCode == EXCEPTION_STACK_OVERFLOW;
  return full ? end_at_once(why) : EXCEPTION_CONTINUE_SEARCH;
}

void aborted(int) { shared->aborted = true; }

void not_caught() { end_with(ended::not_caught); }

}  // namespace

void prepare_judged_process() {
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
  SetUnhandledExceptionFilter(end_at_once);
  AddVectoredExceptionHandler(1, end_on_a_full_stack);
  std::thread(note_work).detach();
  std::signal(SIGABRT, aborted);
  std::set_terminate(not_caught);
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // no line is lost in a crash
  begin_question();
}

void begin_question() { tell({"question"}); }

void finish() {
  shared->read_input = !std::cin || std::feof(stdin);
  tell({"all checks ran"});
}

void end_without_memory() { end_with(ended::no_memory); }

}  // namespace bounce::check
