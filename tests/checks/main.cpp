// Checks one stage: usage: stage_checks NN_name|loop MODULE [--course MODULE] [--report FILE.json]
//                                       [--must-fail-as FILE.hpp]
// MODULE is the compiled stage (subject.hpp). Exit code 0: all checks pass; 1: one does not; 2: bad
// input. With --must-fail-as, 0 only if the check and the mistake are those named in FILE's first
// lines (`// check: ...`, `// told: ...`).

#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <dlfcn.h>
#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "checks/judge.hpp"
#include "checks/run_check.hpp"
#include "checks/verdict.hpp"
#include "checks/watched.hpp"

namespace {

using namespace bounce::check;

const Subject* under_check = nullptr;

const Subject& load(const std::string& path) {
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) end_with(std::string("the compiled stage cannot be loaded: ") + dlerror());
  using Entry = const void* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(module, "bounce_subject"));
  if (!entry) end_with(path + " is no compiled stage");
  return *static_cast<const Subject*>(entry());
}

/// Tells the judge, check by check.
struct TellingReporter final : doctest::IReporter {
  explicit TellingReporter(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& in) override {
    tell({"check", in.m_name});
    begin_question();
  }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    tell(stats.testCaseSuccess ? Record{"ok"} : record_of(last_finding()));
  }
  void test_case_exception(const doctest::TestCaseException& thrown) override {
    end_with(std::string("the check itself failed: ") + thrown.error_string.c_str());
  }
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_REPORTER("telling", 1, TellingReporter);

bool run_checks(const std::string& stage) {
  doctest::Context context;
  context.setOption("reporters", "telling");
  context.setOption("test-suite", stage.c_str());
  context.setOption("order-by", "file");
  context.setOption("abort-after", 1);
  context.setOption("no-intro", true);
  context.setOption("no-version", true);
  return context.run() == 0;
}

std::string with_format(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void tell_speed(const Subject& course, int stage) {
  begin_question();
  for (const SpeedRow& row : speed_against_error(*under_check, course, speed_runs(stage))) {
    tell({"speed", with_format("%g", row.dt), with_format("%.2e", row.error),
          with_format("%.2e", row.course_error), with_format("%.2f", row.ns),
          with_format("%.2f", row.course_ns)});
  }
}

int usage() {
  std::cerr << "usage: stage_checks NN_name MODULE [--course MODULE] [--report FILE] "
               "[--must-fail-as FILE]\n";
  return 2;
}

struct Words {
  std::string stage, module, course, report, mistake;
};

/// What happens in the judged process.
void check(const Words& words) {
  const Watched watched(load(words.module));
  under_check = &watched;
  const bool passed = run_checks(words.stage);
  finish();
  if (passed && !conclusion().empty()) tell({"verdict", conclusion()});
  if (passed && conclusion().empty() && !words.course.empty() && !has_printed()) {
    tell_speed(load(words.course), std::stoi(words.stage));
  }
}

int judge_stage(const Words& words) {
  Verdict verdict(!words.mistake.empty());
  verdict.end(run_apart([&] { check(words); }, [&](const Record& r) { verdict.hear(r); }));
  if (!verdict.found_checks()) {
    std::cerr << "stage_checks: there are no checks for '" << words.stage << "'\n";
    return 2;
  }
  if (!words.mistake.empty()) return verdict.compare_with(words.mistake);
  if (!words.report.empty() && !verdict.write_report(words.report, words.stage)) {
    std::cerr << "stage_checks: " << words.report << " cannot be written\n";
    return 1;
  }
  return verdict.passed() ? 0 : 1;
}

}  // namespace

const bounce::check::Subject& bounce::check::subject() { return *under_check; }

int main(int argc, char** argv) {
  const std::vector<std::string> given(argv + 1, argv + argc);
  if (given.size() < 2 || given.size() % 2 != 0) return usage();
  Words words{given[0], given[1], "", "", ""};
  for (std::size_t i = 2; i < given.size(); i += 2) {
    std::string* option = given[i] == "--course"         ? &words.course
                          : given[i] == "--report"       ? &words.report
                          : given[i] == "--must-fail-as" ? &words.mistake
                                                         : nullptr;
    if (!option) return usage();
    *option = given[i + 1];
  }
  if (access(words.module.c_str(), R_OK) != 0) {
    std::cerr << "stage_checks: " << words.module << " cannot be read\n";
    return 2;
  }
  try {
    return judge_stage(words);
  } catch (const std::exception& broken) {
    std::cerr << "stage_checks: " << broken.what() << "\n";
    return 2;
  }
}
