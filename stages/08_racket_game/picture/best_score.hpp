#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace bounce {

/// The best score of all days, in the user's data folder. Where that cannot be read or written, the
/// game goes on without.
class BestScore {
 public:
  BestScore() {
    const auto variable = [](const char* name) -> std::filesystem::path {
      const char* value = std::getenv(name);
      return value == nullptr ? "" : value;
    };
    if (const auto data = variable("XDG_DATA_HOME"); !data.empty()) {
      folder_ = data / "bounce";
    } else if (const auto windows = variable("APPDATA"); !windows.empty()) {
      folder_ = windows / "bounce";
    } else if (const auto home = variable("HOME"); !home.empty()) {
      folder_ = home / ".local" / "share" / "bounce";
    }
  }

  int read() const {
    int best = 0;
    std::ifstream file(folder_ / "racket_game_best.txt");
    return file >> best && best > 0 ? best : 0;
  }

  void write(int best) const {
    if (folder_.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(folder_, ignored);
    std::ofstream(folder_ / "racket_game_best.txt") << best << "\n";
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace bounce
