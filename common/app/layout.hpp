#pragma once
#include "app/canvas.hpp"

/// Where things stand in the window: 1280 x 720 logical pixels, scaled to the real window.
namespace bounce::layout {

inline constexpr int width = 1280;
inline constexpr int height = 720;
inline constexpr Rect scene{0, 0, 748, 540};
inline constexpr Rect chart{64, 16, 340, 452};  // over the scene, left of the ball
inline constexpr Rect energy{748, 0, 92, 540};
inline constexpr Rect plots[2]{{0, 540, 420, 180}, {420, 540, 420, 180}};
inline constexpr Rect panel{848, 8, 424, 704};

}  // namespace bounce::layout
