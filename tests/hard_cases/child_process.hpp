#pragma once
#include <string>
#include <vector>

#include "temporary_folder.hpp"

namespace bounce::test {

/// How a program went.
struct Child {
  int code = -1;             // 128 + the signal that ended it
  bool interrupted = false;  // after the time given, as with Ctrl-C
  bool timed_out = false;    // it did not hear that
  std::string out, err;
  std::string left_behind;  // a file in its folder, if there is one
};

struct InputFile {
  std::string name, content;
};

/// A folder in which programs of the course run, one after the other.
class ChildFolder {
 public:
  /// Runs a program in an empty folder, without a shell and without a display. After so many
  /// seconds it is interrupted, and after twice as many again ended. The files stand in ../in.
  Child run(const std::string& program, const std::vector<std::string>& words,
            const std::vector<InputFile>& files, double seconds);
  /// What the last program wrote into its folder under this name.
  std::string read(const std::string& name) const;
  const std::string& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::string path_ = folder_.path().string();
};

}  // namespace bounce::test
