// Windows has no fork(). The judge starts its own program once more, with the same words; there
// run_apart finds what it inherits in its environment, and does the work.
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <psapi.h>  // after that

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>

#include "checks/ended.hpp"
#include "checks/listener.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

namespace {

constexpr double seconds_a_check = 3;                      // of processor time; a check takes 0.1 s
constexpr std::size_t most_memory = std::size_t{1} << 30;  // bytes
constexpr long long most_output = 16 << 20;                // bytes
constexpr const char* inherited = "BOUNCE_JUDGED";

std::size_t memory(HANDLE process) {
  PROCESS_MEMORY_COUNTERS used{};
  GetProcessMemoryInfo(process, &used, sizeof used);
  return used.PagefileUsage;
}

/// Listens until the process has ended. Else the words for why it has to be ended.
std::string listen(HANDLE process, HANDLE from, HANDLE printed, Listener& listener) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  double worked = 0;
  for (;;) {
    const bool over = WaitForSingleObject(process, 5) == WAIT_OBJECT_0;
    char bytes[4096];
    DWORD waiting = 0, count = 0;
    while (PeekNamedPipe(from, nullptr, 0, nullptr, &waiting, nullptr) && waiting > 0 &&
           ReadFile(from, bytes, std::min<DWORD>(waiting, sizeof bytes), &count, nullptr)) {
      listener.take(bytes, count);
      last = Clock::now();
      worked = shared->worked;
    }
    if (over) return "";
    const double work = shared->worked - worked;
    const double silent = std::chrono::duration<double>(Clock::now() - last).count();
    if (silent > patience && work < patience / 40) return ended::waits;
    LARGE_INTEGER size{};
    GetFileSizeEx(printed, &size);
    if (work > seconds_a_check || size.QuadPart > most_output) return ended::loops;
    if (memory(process) > most_memory) return ended::no_memory;
  }
}

std::string words_for(DWORD code) {
  if (shared->aborted) return ended::aborts;
  switch (code) {
    case EXCEPTION_INT_DIVIDE_BY_ZERO:
    case EXCEPTION_ILLEGAL_INSTRUCTION:
      return ended::divides_by_0;
    case EXCEPTION_STACK_OVERFLOW:
      return ended::calls_itself;
    case EXCEPTION_ACCESS_VIOLATION:
      return ended::bad_address;
    default:
      return ended::exits(static_cast<long>(code));
  }
}

std::FILE* file_of(HANDLE handle) {
  return _fdopen(_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY), "w+b");
}

[[noreturn]] void be_judged_with(const std::string& handles, const std::function<void()>& work) {
  std::istringstream numbers(handles);
  std::intptr_t page = 0, pipe = 0;
  numbers >> page >> pipe;
  shared = static_cast<SharedPage*>(
      MapViewOfFile(reinterpret_cast<HANDLE>(page), FILE_MAP_ALL_ACCESS, 0, 0, 0));
  to_judge = _open_osfhandle(pipe, _O_BINARY);
  be_judged(work);
}

PROCESS_INFORMATION start_again(HANDLE nothing, HANDLE printed) {
  char program[32768];
  GetModuleFileNameA(nullptr, program, sizeof program);
  std::string words = GetCommandLineA();
  STARTUPINFOA start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = nothing;
  start.hStdOutput = start.hStdError = printed;
  PROCESS_INFORMATION process{};
  if (!CreateProcessA(program, words.data(), nullptr, nullptr, TRUE, CREATE_SUSPENDED, nullptr,
                      nullptr, &start, &process)) {
    throw std::runtime_error("no process for your code");
  }
  return process;
}

}  // namespace

Ending run_apart(const std::function<void()>& work,
                 const std::function<void(const Record&)>& heard) {
  if (const char* handles = std::getenv(inherited)) be_judged_with(handles, work);

  SECURITY_ATTRIBUTES shares{sizeof shares, nullptr, TRUE};
  const HANDLE page = CreateFileMappingA(INVALID_HANDLE_VALUE, &shares, PAGE_READWRITE, 0,
                                         sizeof(SharedPage), nullptr);
  HANDLE from = nullptr, to = nullptr;
  char name[MAX_PATH];
  const std::string folder = std::filesystem::temp_directory_path().string();
  const bool named = GetTempFileNameA(folder.c_str(), "bou", 0, name) != 0;
  const HANDLE printed = CreateFileA(name, GENERIC_READ | GENERIC_WRITE,
                                     FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                     &shares, CREATE_ALWAYS, FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  const HANDLE nothing = CreateFileA("NUL", GENERIC_READ, 0, &shares, OPEN_EXISTING, 0, nullptr);
  if (!page || !CreatePipe(&from, &to, &shares, 0) || !named || printed == INVALID_HANDLE_VALUE) {
    throw std::runtime_error("no pipe, no memory, or no temporary file");
  }
  SetHandleInformation(from, HANDLE_FLAG_INHERIT, 0);
  shared = new (MapViewOfFile(page, FILE_MAP_ALL_ACCESS, 0, 0, 0)) SharedPage{};
  output = file_of(printed);
  enter("what runs before any function: global variables");
  std::ostringstream handles;
  handles << inherited << '=' << reinterpret_cast<std::intptr_t>(page) << ' '
          << reinterpret_cast<std::intptr_t>(to);
  _putenv(handles.str().c_str());
  const PROCESS_INFORMATION judged = start_again(nothing, printed);
  const HANDLE job = CreateJobObjectA(nullptr, nullptr);  // with all that it may start
  AssignProcessToJobObject(job, judged.hProcess);
  ResumeThread(judged.hThread);
  CloseHandle(to);
  Listener listener(heard);
  std::string words = listen(judged.hProcess, from, printed, listener);
  DWORD code = 0;
  GetExitCodeProcess(judged.hProcess, &code);
  TerminateJobObject(job, 1);
  if (words.empty()) words = words_for(code);
  return ending_of(listener, words);
}

}  // namespace bounce::check
