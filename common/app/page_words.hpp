#pragma once
#include "app/demo.hpp"

namespace bounce {

/// The simulation that the words of a page ask for: a command line in which each option has a
/// value, of those that say what is run (--set, --method, --dt, --seed, the stage's own). Throws
/// BadInput. (The programs' command line writes files, too, and all that would double what a page
/// loads.)
std::unique_ptr<Simulation> set_up(int argc, const char* const* argv, const Demo& demo);

}  // namespace bounce
