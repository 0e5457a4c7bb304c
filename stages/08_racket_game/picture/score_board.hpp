#pragma once
#include <string>

#include "08_racket_game/run/racket_run.hpp"
#include "app/canvas.hpp"
#include "app/player.hpp"

namespace bounce {

/// A number in large strokes, its right edge at `right`.
void draw_big_number(Canvas& canvas, Point right, float height, int number, Colour colour);

/// Score, settings, keys, and what to do after a loss.
void draw_score_board(Canvas& canvas, const RacketRun& run, Rect area, bool help, bool muted);

/// What the blind player does, and the ball's heights so far.
void draw_blind_history(Canvas& canvas, const RacketRun& run, const Player& player, Rect area);

}  // namespace bounce
