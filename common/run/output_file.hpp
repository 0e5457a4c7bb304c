#pragma once
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "run/file_name.hpp"

namespace bounce {

/// The machine let us down: disk full, ffmpeg missing, no window. Exit code 1.
struct MachineFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that appears under its name only when it is complete: it is written beside it, as
/// PATH.<process>.part, and renamed by `finish`; without `finish` nothing stays behind. A target
/// that is no regular file (a device, a pipe) is written directly, and "-" is standard output.
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

/// A folder that appears under its name only when all of its files are complete: they are written
/// into NAME.<process>.part beside it, which `finish` renames; without `finish` nothing stays
/// behind. A folder that is there already must be empty.
class OutputFolder {
 public:
  /// `option` is what the user gave the path to. Throws BadInput when it cannot be made.
  OutputFolder(const std::string& option, const std::string& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The path of a file in it, to be written before `finish`.
  std::string file(const std::string& name) const { return name_of(part_ / path_of(name)); }
  void finish();  // throws MachineFailure

 private:
  std::string option_;
  std::filesystem::path path_, part_;
  bool finished_ = false;
};

}  // namespace bounce
