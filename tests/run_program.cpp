#include "run_program.hpp"

#ifndef _WIN32
#include <sys/wait.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "temporary_folder.hpp"

namespace bounce::test {

namespace fs = std::filesystem;

static const fs::path& folder() {
  static const TemporaryFolder one;
  return one.path();
}

std::string work_folder() { return (folder() / "work").string(); }

#ifdef _WIN32  // the words of cmd.exe, which knows no other quotes than these
static std::string in_its_quotes(std::string command) {
  std::replace(command.begin(), command.end(), '\'', '"');
  return command;
}
std::string quoted(const std::string& word) { return '"' + word + '"'; }
static const char* const nothing = "NUL";
static const char* const change_folder = "cd /d ";
static int exit_code(int status) { return status; }
/// "A=b C=d" as `set "A=b" && set "C=d" &&`.
static std::string setting(const std::string& environment) {
  std::istringstream variables(environment);
  std::string all;
  for (std::string one; variables >> one;) all += "set \"" + one + "\" && ";
  return all;
}
#else
static const std::string& in_its_quotes(const std::string& command) { return command; }
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}
static const char* const nothing = "/dev/null";
static const char* const change_folder = "cd ";
static int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
static std::string setting(const std::string& environment) { return environment + " "; }
#endif

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Outcome run_program(const std::string& command) { return run_program_with("", command); }

Outcome run_program_with(const std::string& environment, const std::string& command) {
  const fs::path& here = folder();
  fs::remove_all(here);
  fs::create_directories(here / "work");
  const char* emulator = std::getenv("BOUNCE_EMULATOR");  // of another processor: qemu-aarch64
  const std::string out = (here / "out").string(), err = (here / "err").string();
  const std::string shell = change_folder + quoted((here / "work").string()) + " && " +
                            setting(environment) + (emulator ? emulator + std::string(" ") : "") +
                            quoted(BOUNCE_BIN_DIR) + "/" + in_its_quotes(command) + " > " +
                            quoted(out) + " 2> " + quoted(err) + " < " + nothing;
  const int code = exit_code(std::system(shell.c_str()));
  return {code, read_file(out), read_file(err)};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

std::vector<std::string> files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(work_folder())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace bounce::test
