#pragma once
#include <string>

#include "08_racket_game/game/game_run.hpp"
#include "app/canvas.hpp"
#include "app/demo.hpp"
#include "app/playback.hpp"

namespace bounce {

/// Score, settings, keys, and what to do after a loss.
void draw_score_board(Canvas& canvas, const GameRun& run, Rect area, const View& view);

/// What the blind player does, and the ball's heights so far.
void draw_blind_history(Canvas& canvas, const GameRun& run, const Playback& playback, Rect area);

}  // namespace bounce
