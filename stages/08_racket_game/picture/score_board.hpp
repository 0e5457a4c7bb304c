#pragma once

#include "08_racket_game/game/game_run.hpp"
#include "08_racket_game/picture/loss_again.hpp"
#include "app/demo.hpp"
#include "app/playback.hpp"

namespace bounce {

/// Score, settings and keys.
void draw_score_board(Canvas& canvas, const GameRun& run, Rect area, const View& view);

/// After a loss: how it came, and how to go on.
void draw_loss(Canvas& canvas, const GameRun& run, const LossAgain& again, Rect area);

/// What the blind player does, and the ball's heights so far.
void draw_blind_history(Canvas& canvas, const GameRun& run, const Playback& playback, Rect area);

}  // namespace bounce
