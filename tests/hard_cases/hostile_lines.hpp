#pragma once
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "all_stages.hpp"
#include "child_process.hpp"

namespace bounce::test {

// Command lines and files as no lesson has them. What is tried comes from --help and --list's own
// tables, so that a new parameter, option or method is tried, too.

/// What is put in the place of every value. (Missing and given twice come besides.)
inline const std::vector<std::string> bad_values{"abc", "",  "NaN",   "inf",    "-inf",
                                                 "-1",  "0", "1e308", "1e-320", "1,2"};

/// One command line, and what the sentence must name when it is refused.
struct Line {
  std::string program;
  std::vector<std::string> words;
  std::vector<std::string> names = {};
  std::vector<InputFile> files = {};  // that stand beside the run's folder, in ../in

  std::string text() const;  // to be read, and tried again
};

/// FNV-1a, as in the last line of a saved state: so that it is not the checksum that is refused.
inline std::string with_checksum(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  std::ostringstream all;
  all << text << "checksum " << std::hex << hash << "\n";
  return all.str();
}

/// What a stage's program understands.
struct Known {
  const Stage* stage;
  std::vector<std::string> options, flags, parameters, methods;
};

/// Runs the program to ask for its --help.
Known known_of(const Stage& stage);

/// Every parameter and option of a stage with every bad value, missing and given twice, and runs
/// that need more steps or rows than are allowed.
std::vector<Line> lines_about(const Known& known);

/// Every entry or column of the files that the stages read (--load, --replay, --balls,
/// --import-lammps) with every bad value, or missing. Runs programs to have files to spoil.
std::vector<Line> lines_about_files(const std::vector<Known>& all);

/// Lines out of good and bad words; the same ones for the same seed.
std::vector<Line> random_lines(const std::vector<Known>& all, int count, std::uint64_t seed);

/// What is wrong with a sentence that refuses the line; empty: nothing. It must be one line, name
/// what the line says that it must name, and say what would be allowed.
std::string complaint_about_sentence(const Line& line, const std::string& sentence);

}  // namespace bounce::test
