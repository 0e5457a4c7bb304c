// The judged process on Windows. Its limits on time, memory and output are kept by the judge
// (run_apart.cpp, here). What Linux tells as well, and this does not: that a thread is still
// running, or that another process was started.
#include "checks/judged_process.hpp"

#include <windows.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include "checks/ended.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

namespace {

/// Ends at once, and with the reason as exit code: without a box that waits for a click, or a
/// debugger.
LONG WINAPI end_at_once(EXCEPTION_POINTERS* why) {
  TerminateProcess(GetCurrentProcess(), why->ExceptionRecord->ExceptionCode);
  return EXCEPTION_EXECUTE_HANDLER;
}

void aborted(int) { shared->aborted = true; }

void not_caught() { end_with(ended::not_caught); }

}  // namespace

void prepare_judged_process() {
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
  SetUnhandledExceptionFilter(end_at_once);
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
