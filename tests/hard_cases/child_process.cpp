#include "child_process.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "run_program.hpp"

namespace bounce::test {

namespace fs = std::filesystem;

Child ChildFolder::run(const std::string& program, const std::vector<std::string>& words,
                       const std::vector<InputFile>& files, double seconds) {
  const std::string work = path_ + "/run", out = path_ + "/out", err = path_ + "/err";
  const std::string binary = BOUNCE_BIN_DIR "/" + program;
  fs::remove_all(work);
  fs::create_directories(work);
  fs::create_directories(path_ + "/in");
  for (const auto& [name, content] : files) {
    std::ofstream(path_ + "/in/" + name, std::ios::binary) << content;
  }
#ifdef _WIN32  // by a shell, and it may take its time: enough to ask for --help and for files
  std::string line = "cd /d " + quoted(work) + " && " + quoted(binary);
  for (const std::string& word : words) line += " " + quoted(word);
  line += " > " + quoted(out) + " 2> " + quoted(err) + " < NUL";
  (void)seconds;
  Child run;
  run.code = std::system(line.c_str());
#else
  std::vector<char*> argv{const_cast<char*>(binary.c_str())};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) std::abort();  // and never kill(-1)
  if (child == 0) {             // from here to exec only what is safe beside other threads
    const int in = open("/dev/null", O_RDONLY);
    const int to_out = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int to_err = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(in, 0), dup2(to_out, 1), dup2(to_err, 2);
    if (chdir(work.c_str()) != 0) _exit(127);
    execv(binary.c_str(), argv.data());
    _exit(127);
  }
  Child run;
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
    if (waited.count() > seconds && !run.interrupted) {
      run.interrupted = true;
      kill(child, SIGINT);
    }
    if (waited.count() > 3 * seconds && !run.timed_out) {
      run.timed_out = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(waited.count() < 0.05 ? 300 : 5000));
  }
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
#endif
  run.out = read_file(out);
  run.err = read_file(err);
  for (const auto& entry : fs::recursive_directory_iterator(work)) {
    run.left_behind = entry.path().filename().string();
  }
  return run;
}

std::string ChildFolder::read(const std::string& name) const {
  return read_file(path_ + "/run/" + name);
}

}  // namespace bounce::test
