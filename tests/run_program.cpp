#include "run_program.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace bounce::test {

namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = make();
  ~Folder() { fs::remove_all(path); }
  static fs::path make() {
    std::string name = (fs::temp_directory_path() / "bounce_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    return name;
  }
};

const fs::path& folder() {
  static const Folder one;
  return one.path;
}

}  // namespace

std::string work_folder() { return (folder() / "work").string(); }

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

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
  const std::string shell = "cd " + quoted((here / "work").string()) + " && " + environment + " " +
                            quoted(BOUNCE_BIN_DIR) + "/" + command + " > " +
                            quoted((here / "out").string()) + " 2> " +
                            quoted((here / "err").string()) + " < /dev/null";
  const int status = std::system(shell.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          read_file((here / "out").string()), read_file((here / "err").string())};
}

}  // namespace bounce::test
