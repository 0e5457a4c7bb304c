#include "app/key_map.hpp"

#include <filesystem>

#include "app/kept_number.hpp"
#include "physics/text.hpp"
#include "run/input_file.hpp"

namespace bounce {
namespace {

SDL_Scancode key_named(const InputFile& file, std::string name) {
  const auto begin = name.find_first_not_of(" \t"), end = name.find_last_not_of(" \t\r");
  name = begin == std::string::npos ? "" : name.substr(begin, end - begin + 1);
  const SDL_Scancode key = SDL_GetScancodeFromName(name.c_str());
  if (key == SDL_SCANCODE_UNKNOWN) {
    file.refuse_line("there is no key '" + name.substr(0, 40) + "'");
  }
  return key;
}

}  // namespace

std::string KeyMap::usual_path() {
  const std::string folder = kept_folder();
  return folder.empty() ? "" : (std::filesystem::path(folder) / "keys.txt").string();
}

void KeyMap::read(const std::string& path) {
  InputFile file("--keys", path, "it must be a text file with lines such as 'J = A'");
  while (file.next_line()) {
    const std::string line = file.line().substr(0, file.line().find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) file.refuse_line("it has no '='");
    const SDL_Scancode key = key_named(file, line.substr(0, equals));
    other_[key] = key_named(file, line.substr(equals + 1));
  }
}

SDL_Keysym KeyMap::meaning_of(SDL_Keysym pressed) const {
  const auto found = other_.find(pressed.scancode);
  if (found == other_.end()) return pressed;
  pressed.scancode = found->second;
  pressed.sym = SDL_GetKeyFromScancode(found->second);
  return pressed;
}

bool KeyMap::is_down(const Uint8* keys, SDL_Scancode wanted) const {
  for (const auto& [key, meaning] : other_) {
    if (meaning == wanted && keys[key] != 0) return true;
  }
  return keys[wanted] != 0 && other_.count(wanted) == 0;
}

}  // namespace bounce
