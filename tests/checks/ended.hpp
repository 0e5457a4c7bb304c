#pragma once
#include <string>

/// How the learner's code ended, in words for a beginner.
namespace bounce::check::ended {

constexpr const char* waits =
    "your code waits for something that does not come: an input, a sleep, or a lock. "
    "Nobody types here";
constexpr const char* forks = "your code calls fork(): it must start no other process";
constexpr const char* loops = "your code does not come back: is there a loop that never ends?";
constexpr const char* divides_by_0 = "your code divided a whole number by 0";
constexpr const char* aborts =
    "your code stopped itself: an assert that is not true, an index outside of a vector, or "
    "abort()";
constexpr const char* calls_itself =
    "a function calls itself again and again, without end, until the memory for calls is full";
constexpr const char* bad_address =
    "your code uses memory that is not its own: an index outside of an array, or a pointer to "
    "nothing";
constexpr const char* no_memory =
    "your code asks for more memory than there is: is there a vector that grows without end?";
constexpr const char* not_caught =
    "a thread or a noexcept function let an exception out, or a std::thread was neither joined nor "
    "detached";

inline std::string exits(long code) {
  return "your code ended the whole program, with exit(" + std::to_string(code) +
         ") or the like. A function ends with return";
}
inline std::string from_outside(const std::string& why) {
  return "your code was ended from outside (" + why + ")";
}

}  // namespace bounce::check::ended
