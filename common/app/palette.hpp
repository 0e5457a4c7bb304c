#pragma once
#include <algorithm>
#include <cstdint>

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
inline constexpr Colour shadow{0, 0, 0};  // dark in the dark, too

/// In the dark light and dark change places, and every hue stays. (As pen.js of the page has it.)
constexpr Colour darkened(Colour c) {
  const int high = std::max({c.red, c.green, c.blue}), low = std::min({c.red, c.green, c.blue});
  const double wanted = 20 + (255 - (high + low) / 2.0) * 0.86;
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
  };
  if (high - low < 8) return {byte(wanted - 4), byte(wanted), byte(wanted + 5), c.alpha};
  // As colourful as before, where there is room.
  const double middle = 2 * wanted - 255;
  const double half = std::min<double>(high - low, 255 - (middle < 0 ? -middle : middle)) / 2;
  const auto moved = [&](int part) {
    return byte(wanted + (2.0 * (part - low) / (high - low) - 1) * half);
  };
  return {moved(c.red), moved(c.green), moved(c.blue), c.alpha};
}

}  // namespace bounce::palette
