#pragma once
#include <functional>
#include <string>

#include "checks/judged_process.hpp"

namespace bounce::check {

constexpr double patience = 5;  // s without an answer and without work

/// Cuts what came over the pipe into records, and hands them on.
class Listener {
 public:
  explicit Listener(const std::function<void(const Record&)>& heard) : heard_(heard) {}
  std::string ended_with;
  bool all_ran = false;

  void take(const char* bytes, std::size_t count) {
    for (const char c : std::string(bytes, count)) {
      if (c == '\0') {
        record_.push_back(word_), word_.clear();
      } else if (c == '\1') {
        finish(record_);
        record_.clear();
      } else {
        word_ += c;
      }
    }
  }

 private:
  void finish(const Record& record) {
    if (record.size() == 2 && record[0] == "ended") {
      ended_with = record[1];
    } else if (record.size() == 1 && record[0] == "all checks ran") {
      all_ran = true;
    } else {
      heard_(record);
    }
  }
  const std::function<void(const Record&)>& heard_;
  Record record_;
  std::string word_;
};

/// What the judge knows in the end; `otherwise`: in these words, unless the code said by itself how
/// it ended.
Ending ending_of(const Listener& listener, const std::string& otherwise);

}  // namespace bounce::check
