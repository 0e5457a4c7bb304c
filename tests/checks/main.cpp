// Checks one stage: usage: stage_checks NN_name MODULE [--course MODULE] [--report FILE.json]
//                                       [--must-fail-as FILE.hpp]
// MODULE is the compiled stage (subject.hpp). Exit code 0: all checks pass; 1: one does not; 2: bad
// input. With --must-fail-as, 0 only if the check and the mistake are those named in FILE's first
// lines (`// check: ...`, `// told: ...`).

#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <dlfcn.h>
#include <doctest/doctest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "checks/judge.hpp"
#include "checks/run_check.hpp"

namespace {

using namespace bounce::check;

const Subject* under_check = nullptr;

const Subject* load(const std::string& path) {
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) {
    std::cerr << "stage_checks: " << dlerror() << "\n";
    std::exit(2);
  }
  using Entry = const void* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(module, "bounce_subject"));
  if (!entry) {
    std::cerr << "stage_checks: " << path << " is no compiled stage\n";
    std::exit(2);
  }
  return static_cast<const Subject*>(entry());
}

/// Code that never comes back, or crashes, is told so in words.
void give_up(int signal) {
  const char* words =
      signal == SIGALRM ? "\n  Your code does not come back: is there a loop that never ends?\n"
                        : "\n  Your code crashed (a bad index or pointer, or a division by a whole "
                          "number 0).\n";
  const auto ignored = write(STDOUT_FILENO, words, std::strlen(words));
  _exit(static_cast<int>(ignored >= 0));
}

struct Checked {
  std::string name;
  bool passed;
};
std::vector<Checked> done;
bool quiet = false;

void explain(const Finding& found) {
  const auto line = [](const char* label, const std::string& text) {
    if (!text.empty()) std::printf("    %-9s %s\n", label, text.c_str());
  };
  std::printf("\n");
  line("tested", found.tested);
  line("where", found.where);
  line("at", found.when);
  line("got", found.got);
  line("expected", found.expected);
  line("likely",
       found.mistake == not_among_them ? found.advice : found.mistake + ": " + found.advice);
  line("lesson", found.lesson);
  std::printf("\n");
}

/// One line for each check that passes, and the finding where the first one does not.
struct VerdictReporter final : doctest::IReporter {
  const doctest::TestCaseData* current = nullptr;
  explicit VerdictReporter(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& in) override { current = &in; }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    done.push_back({current->m_name, stats.testCaseSuccess});
    if (quiet) return;
    std::printf("  %s  %s\n", stats.testCaseSuccess ? "ok     " : "not yet", current->m_name);
    if (!stats.testCaseSuccess) explain(last_finding());
    std::fflush(stdout);
  }
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_REPORTER("verdict", 1, VerdictReporter);

bool run_checks(const std::string& stage) {
  doctest::Context context;
  context.setOption("reporters", "verdict");
  context.setOption("test-suite", stage.c_str());
  context.setOption("order-by", "file");
  context.setOption("abort-after", 1);
  context.setOption("no-intro", true);
  context.setOption("no-version", true);
  return context.run() == 0;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

bool write_report(const std::string& path, const std::string& stage, bool passed) {
  std::ofstream out(path);
  out << "{\"stage\": " << quoted(stage) << ", \"status\": \"" << (passed ? "passed" : "failed")
      << "\", \"checks\": [";
  for (std::size_t i = 0; i < done.size(); ++i) {
    out << (i ? ", " : "") << "{\"name\": " << quoted(done[i].name)
        << ", \"passed\": " << (done[i].passed ? "true" : "false") << "}";
  }
  out << "]";
  if (!passed) {
    const Finding& f = last_finding();
    out << ", \"mistake\": " << quoted(f.mistake) << ", \"got\": " << quoted(f.got)
        << ", \"expected\": " << quoted(f.expected);
  }
  out << "}\n";
  return static_cast<bool>(out.flush());
}

/// The words behind `// check:` or `// told:` in the first lines of a mistake's file.
std::string named(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("// " + key + ": ", 0) == 0) return line.substr(key.size() + 5);
  }
  return "";
}

int judge_mistake(const std::string& path) {
  const std::string check = named(path, "check"), told = named(path, "told");
  const bool failed = !done.empty() && !done.back().passed;
  const std::string in = failed ? done.back().name : "no check at all";
  const std::string as = failed ? last_finding().mistake : "nothing";
  if (failed && check == in && told == as) return 0;
  // A skeleton names neither: it must fail because nothing is written.
  if (failed && check.empty() && told.empty() && as == nothing_written) return 0;
  std::printf("should fail in  %s\n  as            %s\nbut failed in   %s\n  as            %s\n",
              check.c_str(), told.c_str(), in.c_str(), as.c_str());
  if (failed) explain(last_finding());
  return 1;
}

void show_speed(const Subject& course, int stage) {
  std::printf("\n  Speed against error, your code beside the course's:\n\n");
  std::printf("    %-8s %14s %14s %12s %12s\n", "dt [s]", "error [m]", "course's [m]", "ns a step",
              "course's");
  for (const SpeedRow& row : speed_against_error(*under_check, course, speed_runs(stage))) {
    std::printf("    %-8g %14.2e %14.2e %12.2f %12.2f\n", row.dt, row.error, row.course_error,
                row.ns, row.course_ns);
  }
}

int usage() {
  std::cerr << "usage: stage_checks NN_name MODULE [--course MODULE] [--report FILE] "
               "[--must-fail-as FILE]\n";
  return 2;
}

}  // namespace

const bounce::check::Subject& bounce::check::subject() { return *under_check; }

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2 || words.size() % 2 != 0) return usage();
  std::string course, report, mistake;
  for (std::size_t i = 2; i < words.size(); i += 2) {
    std::string* option = words[i] == "--course"         ? &course
                          : words[i] == "--report"       ? &report
                          : words[i] == "--must-fail-as" ? &mistake
                                                         : nullptr;
    if (!option) return usage();
    *option = words[i + 1];
  }
  for (const int signal : {SIGALRM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) {
    std::signal(signal, give_up);
  }
  alarm(20);
  under_check = load(words[1]);
  quiet = !mistake.empty();
  const bool passed = run_checks(words[0]);
  if (done.empty()) {
    std::cerr << "stage_checks: there are no checks for '" << words[0] << "'\n";
    return 2;
  }
  if (!mistake.empty()) return judge_mistake(mistake);
  if (!report.empty() && !write_report(report, words[0], passed)) {
    std::cerr << "stage_checks: " << report << " cannot be written\n";
    return 1;
  }
  if (passed && !course.empty()) show_speed(*load(course), std::stoi(words[0]));
  return passed ? 0 : 1;
}
