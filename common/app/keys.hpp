#pragma once
#include <vector>

#include "app/demo.hpp"

namespace bounce {

struct Key {
  const char* key;
  const char* meaning;
};

/// The keys of a demo that is no game, for the page of help.
std::vector<Key> keys_of(const Demo& demo);

/// A game has no panel, and takes Space and the arrows for itself.
inline bool is_game(const Demo& demo) { return demo.control && demo.bare; }

/// What a key does when it goes down, in a window and in a web page: 'p', '.', '-'; '?' is the page
/// of help. Returns whether it does anything.
bool press(char key, const Demo& demo, Playback& playback, View& view, Controls& controls);

}  // namespace bounce
