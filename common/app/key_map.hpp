#pragma once
#include <SDL.h>

#include <map>
#include <string>

namespace bounce {

/// Which key does what another one does. A text file, with a line for each, such as `J = A`: from
/// then on J does what A did. The names are SDL's, of places on a keyboard with English letters; a
/// line that begins with # is a comment.
class KeyMap {
 public:
  /// Throws BadInput, with the line that is wrong.
  void read(const std::string& path);

  /// What a key that is pressed stands for.
  SDL_Keysym meaning_of(SDL_Keysym pressed) const;
  /// A key that stands for this one: it itself, if no other does.
  SDL_Scancode key_for(SDL_Scancode wanted) const;
  /// Is any key down that stands for this one?
  bool is_down(const Uint8* keys, SDL_Scancode wanted) const;

 private:
  std::map<SDL_Scancode, SDL_Scancode> other_;  // from the key to what it does
};

}  // namespace bounce
