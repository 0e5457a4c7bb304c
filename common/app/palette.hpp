#pragma once
#include "app/canvas.hpp"

/// Colour = quantity, the same in every stage; a force and its energy share one. The four are told
/// apart with any colour vision (tests/app/palette_test.cpp computes contrast and distances), and
/// each has a second cue besides.
namespace bounce::palette {

inline constexpr Colour paper{0xFA, 0xFA, 0xF7};
inline constexpr Colour ink{0x20, 0x26, 0x2E};      // text, outlines, the net force
inline constexpr Colour motion{0x00, 0x72, 0xB2};   // velocity, kinetic energy: fat arrow
inline constexpr Colour gravity{0x6A, 0x1B, 0x74};  // weight, potential energy: points down
inline constexpr Colour spring{0x00, 0x9E, 0x73};   // spring force and energy: left of the contact
inline constexpr Colour damper{0xD5, 0x5E,
                               0x00};             // damper force, lost energy: right of it, hatched
inline constexpr Colour exact{0x5F, 0x6B, 0x76};  // the exact solution: outline only, dashed
inline constexpr Colour grid_minor{0xEC, 0xED, 0xEA};
inline constexpr Colour grid_major{0xDA, 0xDC, 0xD8};
inline constexpr Colour warning{0xF0, 0xE4, 0x42};  // always under ink, with a word
inline constexpr Colour ball{0xE4, 0xE8, 0xEC};

}  // namespace bounce::palette
