// What the judged process says, on every system.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <iostream>

#include "checks/judged_process.hpp"
#include "checks/shared_page.hpp"

namespace bounce::check {

void be_judged(const std::function<void()>& work) {
  prepare_judged_process();
  work();
  std::cout.flush();
  std::fflush(nullptr);
  _exit(0);
}

void tell(const Record& record) {
  std::string text;
  for (const std::string& word : record) text += word + '\0';
  text += '\1';
  for (std::size_t sent = 0; sent < text.size();) {
    const auto now = write(to_judge, text.data() + sent, static_cast<unsigned>(text.size() - sent));
    if (now <= 0) _exit(1);
    sent += static_cast<std::size_t>(now);
  }
}

void enter(const char* function) {
  if (shared) std::strncpy(shared->function, function, sizeof shared->function - 1);
}

void end_with(const std::string& words) {
  tell({"ended", words});
  _exit(1);
}

bool has_printed() {
  std::cout.flush();
  std::fflush(nullptr);
  struct stat file {};
  return fstat(STDOUT_FILENO, &file) == 0 && file.st_size > 0;
}

}  // namespace bounce::check
