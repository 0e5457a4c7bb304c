#pragma once
#include <filesystem>
#include <string>

namespace bounce {

/// A file's name as a path, and back. Names are UTF-8 on every system; a path made of a std::string
/// would take each byte for a letter on Windows.
inline std::filesystem::path path_of(const std::string& name) {
  return std::u8string(name.begin(), name.end());
}
inline std::string name_of(const std::filesystem::path& path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

}  // namespace bounce
