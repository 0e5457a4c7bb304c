#pragma once
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

namespace bounce::test {

/// A new folder in the system's one for temporary files, which no other run or user has; it is gone
/// when this is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::random_device random;
    do {
      path_ = std::filesystem::temp_directory_path() / ("bounce_test_" + std::to_string(random()));
    } while (!std::filesystem::create_directory(path_));  // there is one already
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// From here on it is the system's one, for this program and for those that it starts.
  void use_for_all() const {
#ifdef _WIN32
    _putenv_s("TMP", path_.string().c_str());
#else
    setenv("TMPDIR", path_.c_str(), 1);
#endif
  }

 private:
  std::filesystem::path path_;
};

}  // namespace bounce::test
