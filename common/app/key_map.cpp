#include "app/key_map.hpp"

#include <vector>

#include "run/input_file.hpp"

namespace bounce {
namespace {

SDL_Scancode key_named(const InputFile& file, const std::string& name) {
  const SDL_Scancode key = SDL_GetScancodeFromName(name.c_str());
  if (key == SDL_SCANCODE_UNKNOWN) {
    file.refuse_line("there is no key '" + name.substr(0, 40) + "'");
  }
  return key;
}

}  // namespace

void KeyMap::read(const std::string& path) {
  InputFile file("--keys", path, "it must be a text file with lines such as 'J = A'");
  while (file.next_line()) {
    if (file.line().empty() || file.line()[0] == '#') continue;
    const std::vector<std::string> words = split(file.line(), '=');
    if (words.size() != 2) file.refuse_line("it must be two keys and a '='");
    const SDL_Scancode key = key_named(file, words[0]);
    other_[key] = key_named(file, words[1]);
  }
}

SDL_Keysym KeyMap::meaning_of(SDL_Keysym pressed) const {
  const auto found = other_.find(pressed.scancode);
  if (found == other_.end()) return pressed;
  pressed.scancode = found->second;
  pressed.sym = SDL_GetKeyFromScancode(found->second);
  return pressed;
}

SDL_Scancode KeyMap::key_for(SDL_Scancode wanted) const {
  for (const auto& [key, meaning] : other_) {
    if (meaning == wanted) return key;
  }
  return wanted;
}

bool KeyMap::is_down(const Uint8* keys, SDL_Scancode wanted) const {
  for (const auto& [key, meaning] : other_) {
    if (meaning == wanted && keys[key] != 0) return true;
  }
  return keys[wanted] != 0 && other_.count(wanted) == 0;
}

}  // namespace bounce
