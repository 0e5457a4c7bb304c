#pragma once
#include <string>
#include <vector>

namespace bounce::test {

/// There is no /dev/full there, no signal and no limit, which some tests need.
#ifdef _WIN32
inline constexpr bool on_windows = true;
#else
inline constexpr bool on_windows = false;
#endif

/// What a program printed and how it ended.
struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/// Runs one of the course's programs, "03_damping --headless ...", in a fresh folder of its own.
Outcome run_program(const std::string& command);
/// The same with something set for it: "SDL_VIDEODRIVER=dummy".
Outcome run_program_with(const std::string& environment, const std::string& command);

/// The folder in which the last program ran; the next one empties it.
std::string work_folder();

/// The names of what lies there, in order.
std::vector<std::string> files();

/// One word of a shell's command line, whatever is in it: "'Anna'\\''s work'".
std::string quoted(const std::string& word);

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The lines of a text, without their ends.
std::vector<std::string> lines(const std::string& text);

/// A whole file; empty when it is not there.
std::string read_file(const std::string& path);

}  // namespace bounce::test
