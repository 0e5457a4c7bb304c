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

/// The method that a run begins with, and what the window and the terminal say of it. (Another
/// name for the method: what has internal linkage may not be used itself in an inline function.)
#ifdef BOUNCE_COURSE_FORCE
#define BOUNCE_WHOSE_FORCE "the course's force, "
#else
#define BOUNCE_WHOSE_FORCE "your force, "
#endif
#if defined BOUNCE_MY_METHOD
[[maybe_unused]] static constexpr const Method& first_method = methods::mine;
constexpr const char* whose_lines = BOUNCE_WHOSE_FORCE "your method";
#elif defined BOUNCE_MY_LOOP
[[maybe_unused]] static constexpr const Method& first_method = methods::my_loop;
constexpr const char* whose_lines = BOUNCE_WHOSE_FORCE "your loop";
#else
[[maybe_unused]] static constexpr const Method& first_method = methods::semi_implicit_euler;
constexpr const char* whose_lines = is_mine ? BOUNCE_WHOSE_FORCE "the course's loop" : "";
#endif
#undef BOUNCE_WHOSE_FORCE

}  // namespace bounce
