#pragma once
#include <array>

#include "app/demo.hpp"

namespace bounce {

struct Key {
  const char* key;
  const char* meaning;
};

/// The keys of all stages, for the page of help.
inline constexpr std::array<Key, 10> all_keys{
    {{"P, Space", "pause, play"},
     {".  or Right", "one step forward"},
     {",  or Left", "one step back"},
     {"R", "restart"},
     {"O", "slow motion (1/10)"},
     {"L", "contact lens: a contact lasts a second"},
     {"E", "speed against error, now: click a dot to choose it"},
     {"T", "from above, from the side (stages in space)"},
     {"mouse", "drag the ball, and throw it"},
     {"F1", "this page"}}};

/// A game has no panel, and takes Space and the arrows for itself.
inline bool is_game(const Demo& demo) { return demo.control && demo.bare; }

/// What a key does when it goes down, in a window and in a web page: 'p', '.', '-'; '?' is the page
/// of help. Returns whether it does anything.
bool press(char key, const Demo& demo, Playback& playback, View& view, Controls& controls);

}  // namespace bounce
