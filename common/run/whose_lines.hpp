#pragma once

namespace bounce {

/// Whether this program runs on a learner's lines (`./course play N --mine`) in place of the
/// course's. For the files of the stages only: the libraries are compiled once, for both.
#ifdef BOUNCE_MINE
inline constexpr bool is_mine = true;
#else
inline constexpr bool is_mine = false;
#endif

}  // namespace bounce
