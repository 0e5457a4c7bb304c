#pragma once
#include <cstdio>
#include <functional>

namespace bounce::check {

/// Seen by both processes, the judge's and the judged one: who dies cannot speak.
struct SharedPage {
  char function[64];  // of the learner's, that was called last
  bool stack_overflow, read_input, forked, aborted;
  volatile double worked;  // s of processor time, on Windows
};
inline SharedPage* shared = nullptr;
inline FILE* output = nullptr;  // what the code prints
inline int to_judge = -1;       // the pipe

/// The judged process, from its first moment to its last.
[[noreturn]] void be_judged(const std::function<void()>& work);
void prepare_judged_process();  // limits, and where its output goes

}  // namespace bounce::check
