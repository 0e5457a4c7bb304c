#include "checks/verdict.hpp"

#include <cstdio>
#include <fstream>

namespace bounce::check {

namespace {

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
  line("seen", found.seen);
  const bool known = found.mistake != not_among_them;
  line(known ? "likely" : "look at", (known ? found.mistake + ": " : "") + found.advice);
  line("lesson", found.lesson);
  std::printf("\n");
}

Finding finding_in(const Record& r) {
  return {r.at(1), r.at(2), r.at(3), r.at(4), r.at(5), r.at(6), r.at(7), r.at(8), r.at(9)};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return out + "\"";
}

/// The words behind `// key: ` in the first lines of a mistake's file.
std::string named(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("// " + key + ": ", 0) == 0) return line.substr(key.size() + 5);
  }
  return "";
}

}  // namespace

Record record_of(const Finding& f) {
  return {"failed",   f.tested, f.where,   f.when,   f.got,
          f.expected, f.seen,   f.mistake, f.advice, f.lesson};
}

void Verdict::hear(const Record& record) {
  const std::string kind = record.empty() ? "" : record[0];
  if (kind == "check" && record.size() == 2) checking_ = record[1];
  if (kind == "ok") {
    done_.push_back({checking_, true});
    if (!quiet_) std::printf("  ok       %s\n", checking_.c_str());
  }
  if (kind == "failed" && record.size() == 10) {
    done_.push_back({checking_, false});
    finding_ = finding_in(record);
    if (!quiet_) std::printf("  not yet  %s\n", checking_.c_str());
    if (!quiet_) explain(finding_);
  }
  if (kind == "verdict" && record.size() == 2) {
    verdict_ = record[1];
    if (!quiet_) std::printf("\n  %s\n", verdict_.c_str());
  }
  if (kind == "speed" && record.size() == 6) {
    if (!speed_shown_) {
      std::printf("\n  Speed against error, your code beside the course's:\n\n");
      std::printf("    %-8s %14s %14s %12s %12s\n", "dt [s]", "error [m]", "course's [m]",
                  "ns a step", "course's");
    }
    speed_shown_ = true;
    std::printf("    %-8s %14s %14s %12s %12s\n", record[1].c_str(), record[2].c_str(),
                record[3].c_str(), record[4].c_str(), record[5].c_str());
  }
  std::fflush(stdout);
}

void Verdict::end(const Ending& ending) {
  ending_ = ending;
  if (speed_shown_) {
    std::printf(
        "    (Both in one short run of the checks, with asserts on: lessons and play measure "
        "other runs.)\n");
  }
  if (!quiet_) show_ending();
}

void Verdict::show_ending() const {
  if (!ending_.words.empty()) {
    if (!checking_.empty()) std::printf("  not yet  %s\n", checking_.c_str());
    std::printf("\n    It did not come to an end: %s.\n", ending_.words.c_str());
    std::printf("    It happened in %s, or in what that calls.\n\n", ending_.where.c_str());
  }
  if (ending_.read_input) {
    std::printf("    Your code reads from std::cin. Nobody types here, so it read nothing.\n\n");
  }
  if (ending_.lines == 0) return;
  std::printf("\n    Your code printed %ld line%s:\n", ending_.lines,
              ending_.lines == 1 ? "" : "s");
  for (const std::string& line : ending_.printed) std::printf("      %s\n", line.c_str());
  if (static_cast<long>(ending_.printed.size()) < ending_.lines) std::printf("      ...\n");
  if (passed()) std::printf("    (Printing takes time, so the table of speeds is left out.)\n");
  std::printf("\n");
}

bool Verdict::write_report(const std::string& path, const std::string& stage) const {
  std::ofstream out(path);
  const char* status = passed() ? "passed" : ending_.words.empty() ? "failed" : "crashed";
  out << "{\"stage\": " << quoted(stage) << ", \"status\": \"" << status << "\", \"checks\": [";
  for (std::size_t i = 0; i < done_.size(); ++i) {
    out << (i ? ", " : "") << "{\"name\": " << quoted(done_[i].name)
        << ", \"passed\": " << (done_[i].passed ? "true" : "false") << "}";
  }
  out << "]";
  if (!verdict_.empty()) out << ", \"verdict\": " << quoted(verdict_);
  if (!ending_.words.empty()) {
    out << ", \"mistake\": " << quoted(ending_.words) << ", \"in\": " << quoted(ending_.where);
  } else if (failed()) {
    out << ", \"mistake\": " << quoted(finding_.mistake) << ", \"seen\": " << quoted(finding_.seen)
        << ", \"got\": " << quoted(finding_.got) << ", \"expected\": " << quoted(finding_.expected);
  }
  out << "}\n";
  return static_cast<bool>(out.flush());
}

int Verdict::compare_with(const std::string& file) const {
  const std::string check = named(file, "check"), told = named(file, "told");
  const std::string seen = named(file, "seen"), advice = named(file, "advice");
  const std::string in = failed() ? done_.back().name : "no check at all";
  const std::string as = failed() ? finding_.mistake : "nothing";
  if (failed() && check == in && told == as && finding_.seen.find(seen) != std::string::npos &&
      finding_.advice.find(advice) != std::string::npos) {
    return 0;
  }
  // A skeleton names neither: it must fail because nothing is written.
  if (failed() && check.empty() && told.empty() && as == all_zero) return 0;
  std::printf("should fail in  %s\n  as            %s\nbut failed in   %s\n  as            %s\n",
              check.c_str(), told.c_str(), in.c_str(), as.c_str());
  if (failed()) explain(finding_);
  show_ending();
  return 1;
}

}  // namespace bounce::check
