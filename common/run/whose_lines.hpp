#pragma once
#include "physics/methods/mine.hpp"
#include "physics/methods/semi_implicit_euler.hpp"

namespace bounce {

// Whose lines this program runs on: the course's, or (`./course play N --mine`) a learner's. For
// the stages' own files and for templates: the libraries are compiled once, for both.
#ifdef BOUNCE_MINE
constexpr bool is_mine = true;
#else
constexpr bool is_mine = false;
#endif

/// The method that a run begins with, and what the window and the terminal say of it.
#ifdef BOUNCE_MY_LOOP
constexpr Method first_method = methods::mine;
constexpr const char* whose_lines = "your force, your loop";
#else
constexpr Method first_method = methods::semi_implicit_euler;
constexpr const char* whose_lines = is_mine ? "your force, the course's loop" : "";
#endif

}  // namespace bounce
