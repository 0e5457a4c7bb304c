// Command lines as no lesson has them (hostile_lines.hpp), each run as a program of its own, with a
// time limit.
//
//   hostile_command_lines table               every parameter, option and file entry, each with
//   every
//                                             bad value
//   hostile_command_lines random [N [SEED]]   N lines out of good and bad words
//
// Of each run it asks: an exit code of 0, 1, 2 or 3 (of the table: a finite result, or 2); an end
// within the time limit; no sanitizer report; no number in the trace that is none. Of bad input,
// besides: one sentence that names what was wrong and says what is allowed, and nothing left in the
// folder. A line that fails is printed, to be tried again.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <thread>

#include "hostile_lines.hpp"

using namespace bounce;
using namespace bounce::test;

namespace {

// s, for runs that mostly take milliseconds. A run may be long by right (1e11 steps are allowed),
// but then it must end when it is interrupted.
constexpr double time_limit = 10;

enum class Kind { table, random };

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// What is wrong with how it went; empty: nothing.
std::string complaint(Kind kind, const Line& line, const Child& run) {
  if (run.timed_out) return "an interrupt was not heard";
  if (run.interrupted && run.code == 130) return "";
  if (run.code < 0 || run.code > 3) return "exit code " + std::to_string(run.code);
  for (const std::string mark : {"runtime error", "Sanitizer"}) {
    if (contains(run.err, mark)) return "a sanitizer's report";
  }
  for (const std::string none : {",nan", ",-nan", ",inf", ",-inf"}) {
    if (contains(run.out, none)) return "a trace with a number that is none";
  }
  if (run.code == 2) {
    if (!run.left_behind.empty()) return "bad input left the file " + run.left_behind;
    if (!run.out.empty()) return "bad input, and yet an output";
    return complaint_about_sentence(line, run.err);
  }
  // Where a formula ends, only the run can find out.
  if (run.code == 3 && contains(run.err, "there is no closed form")) return "";
  if (kind == Kind::table && run.code != 0) return "exit code " + std::to_string(run.code);
  return "";
}

/// Runs all lines, two at a time. Returns how many went wrong.
int attack(Kind kind, const std::vector<Line>& lines) {
  const auto begin = std::chrono::steady_clock::now();
  std::atomic<std::size_t> next{0};
  std::atomic<int> wrong{0}, interrupted{0};
  std::array<std::atomic<int>, 4> ends{};
  std::mutex screen;
  const auto work = [&] {
    ChildFolder folder;
    for (std::size_t i = next++; i < lines.size(); i = next++) {
      const Line& line = lines[i];
      const Child run = folder.run(line.program, line.words, line.files, time_limit);
      if (run.code >= 0 && run.code <= 3) ++ends[static_cast<std::size_t>(run.code)];
      if (run.interrupted) ++interrupted;
      const std::string why = complaint(kind, line, run);
      if (why.empty()) continue;
      ++wrong;
      const std::lock_guard<std::mutex> hold(screen);
      std::cout << why << ":\n  " << line.text() << "\n  " << run.err.substr(0, 2000) << std::endl;
    }
  };
  std::thread other(work);
  work();
  other.join();
  std::cout << lines.size() << " command lines: " << wrong
            << " went wrong; exit codes 0, 1, 2, 3: ";
  for (const auto& count : ends) std::cout << count << " ";
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::cout << "(" << interrupted << " were interrupted); " << took.count() << " s\n";
  return wrong;
}

}  // namespace

int main(int argc, char** argv) {
  // The game keeps a best score; what a sanitizer finds must not look like a full disk (1).
  const test::ChildFolder home;
  setenv("XDG_DATA_HOME", home.path().c_str(), 1);
  setenv("ASAN_OPTIONS", "exitcode=99", 1);
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  setenv("SDL_AUDIODRIVER", "dummy", 1);
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<Known> all;
  for (const Stage& stage : all_stages()) all.push_back(known_of(stage));
  if (!words.empty() && words[0] == "table") {
    std::vector<Line> lines = lines_about_files(all);
    for (const Known& known : all) {
      const std::vector<Line> more = lines_about(known);
      lines.insert(lines.end(), more.begin(), more.end());
    }
    return attack(Kind::table, lines) == 0 ? 0 : 1;
  }
  if (!words.empty() && words[0] == "random") {
    const int count = words.size() > 1 ? std::atoi(words[1].c_str()) : 10000;
    const std::uint64_t seed = words.size() > 2 ? std::strtoull(words[2].c_str(), nullptr, 10) : 1;
    std::cout << count << " random command lines, seed " << seed << std::endl;
    return attack(Kind::random, random_lines(all, count, seed)) == 0 ? 0 : 1;
  }
  std::cerr << "usage: hostile_command_lines table | random [N [SEED]]\n";
  return 2;
}
