#pragma once
#include <functional>
#include <string>
#include <vector>

namespace bounce::check {

// The judge does not trust the judged. A learner's code runs in a process of its own, where it may
// loop, crash, print or call exit; what the checks find there comes back over a pipe. Only when
// that process says by itself that all checks ran can the verdict be "passed".

using Record = std::vector<std::string>;

/// How the judged process ended, and what the code printed meanwhile.
struct Ending {
  std::string words;                 // for a beginner; empty when it came to its end
  std::string where;                 // which function of the learner's was running
  std::vector<std::string> printed;  // the first lines
  long lines = 0;                    // how many in all
  bool read_input = false;           // from std::cin, where nobody types
};

/// Runs `work` in a process of its own, with limits on time, memory and output; hands on each
/// record that it tells. Unless `work` calls finish(), it did not come to its end.
Ending run_apart(const std::function<void()>& work,
                 const std::function<void(const Record&)>& heard);

// Inside the judged process:
void tell(const Record& record);
/// A new question begins: the time for an answer counts from here.
void begin_question();
/// All questions are answered. What happens after that no longer counts.
void finish();
/// The learner's function that is called now: so that it can be named if it does not come back.
void enter(const char* function);
/// Ends the process, for the reason in `words`.
[[noreturn]] void end_with(const std::string& words);
[[noreturn]] void end_without_memory();
/// Whether the code has printed something so far.
bool has_printed();

}  // namespace bounce::check
