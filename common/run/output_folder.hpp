#pragma once
#include <filesystem>
#include <string>

#include "run/file_name.hpp"

namespace bounce {

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
