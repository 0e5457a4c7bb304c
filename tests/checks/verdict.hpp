#pragma once
#include <string>
#include <vector>

#include "checks/judge.hpp"
#include "checks/judged_process.hpp"

namespace bounce::check {

/// What the judge has heard from the judged process: a line for each check that passes, the finding
/// where the first one does not, or how the process ended.
class Verdict {
 public:
  /// `quiet`: nothing is shown.
  explicit Verdict(bool quiet) : quiet_(quiet) {}

  void hear(const Record& record);
  void end(const Ending& ending);

  bool passed() const { return !done_.empty() && !failed() && ending_.words.empty(); }
  bool failed() const { return !done_.empty() && !done_.back().passed; }
  bool found_checks() const { return !done_.empty() || !ending_.words.empty(); }
  /// For a teacher, as JSON. False: it could not be written.
  bool write_report(const std::string& path, const std::string& stage) const;
  /// 0 if the check and the mistake, or the ending, are those named in the file's first lines.
  int compare_with(const std::string& mistake_file) const;

 private:
  struct Checked {
    std::string name;
    bool passed;
  };
  void show_ending() const;

  bool quiet_;
  std::string checking_;  // the check that is running
  std::vector<Checked> done_;
  Finding finding_;
  Ending ending_;
  std::string verdict_;  // what is said of it when all is passed
  bool speed_shown_ = false;
};

Record record_of(const Finding& finding);

}  // namespace bounce::check
