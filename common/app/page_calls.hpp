#pragma once
#include <exception>
#include <string>
#include <vector>

#include "app/demo.hpp"

namespace bounce {

// What a page asks of a whole stage (window_web.cpp) and of a small figure (figure_web.cpp) alike.

/// Calls `work`. The answer is what it throws, a sentence; or nothing, when all went well.
template <class Work>
const char* guard(std::string& answer, const Work& work) {
  answer.clear();
  try {
    work();
  } catch (const std::exception& error) {
    answer = error.what();
  }
  return answer.c_str();
}

/// The simulation that the words of a page ask for: a command line in which each option has a
/// value, of those that say what is run (--set, --method, --dt, --seed, the stage's own). Throws
/// BadInput. (The programs' command line writes files, too, and all that would double what a page
/// loads.)
std::unique_ptr<Simulation> set_up(int argc, const char* const* argv, const Demo& demo);

/// A dial of the demo's own: whether there is one, and how it is set.
bool is_dial(const Demo& demo, const std::string& name);
void set_dial(const Demo& demo, Simulation& simulation, const std::string& name,
              const std::string& text);

/// A run from the start with the settings of another, at most about `count` rows of t, the trace's
/// columns and, if asked for, the exact solution's; by whole steps. When it throws, the rows before
/// hold.
void run_path(const Simulation& like, double seconds, int count, bool with_exact,
              std::vector<double>& rows);

/// What the page's controls are made from: the tables of parameters and dials, the methods. As
/// JSON. `fresh` has the defaults.
std::string about_page(const Demo& demo, Simulation& simulation, Simulation& fresh);

}  // namespace bounce
