#pragma once
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace bounce {

/// The machine let us down: disk full, ffmpeg missing, no window. Exit code 1.
struct MachineFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where an output stands until it is complete: beside its target, as PATH.<process>.part.
std::string part_path(const std::string& path);

/// A file that appears under its name only when it is complete: it is written at its `part_path`
/// and renamed by `finish`; without `finish` nothing stays behind. A target that is no regular file
/// (a device, a pipe) is written directly, and "-" is standard output.
class OutputFile {
 public:
  /// `option` is what the user gave the path to, for messages ("--csv"). Throws BadInput when the
  /// path cannot be written.
  OutputFile(std::string option, const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Refuses now what would be refused later, and leaves nothing. A device or a pipe is not
  /// touched.
  static void check(const std::string& option, const std::string& path);

  void write(std::string_view text);  // throws MachineFailure
  void finish();                      // throws MachineFailure

  /// The path that is being written, for programs that write it themselves (ffmpeg).
  const std::string& path_in_work() const { return part_; }

 private:
  [[noreturn]] void fail() const;

  std::string option_;
  std::string path_;
  std::string part_;
  std::FILE* file_ = nullptr;
};

}  // namespace bounce
