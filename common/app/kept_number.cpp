#include "app/kept_number.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "run/file_name.hpp"

namespace bounce {

std::filesystem::path kept_folder() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return path_of(value == nullptr ? "" : value);
  };
  if (const auto data = variable("XDG_DATA_HOME"); !data.empty()) return data / "bounce";
  if (const auto windows = variable("APPDATA"); !windows.empty()) return windows / "bounce";
  if (const auto home = variable("HOME"); !home.empty()) {
    return home / ".local" / "share" / "bounce";
  }
  return {};
}

int kept_number(const std::string& name) {
  const std::filesystem::path folder = kept_folder();
  if (folder.empty()) return 0;
  int number = 0;
  std::ifstream file(folder / (name + ".txt"));
  return file >> number && number > 0 ? number : 0;
}

void keep_number(const std::string& name, int number) {
  const std::filesystem::path folder = kept_folder();
  if (folder.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  std::ofstream(folder / (name + ".txt")) << number << "\n";
}

}  // namespace bounce
