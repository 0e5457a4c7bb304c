#include "08_racket_game/picture/loss_again.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

namespace {
constexpr double before_touch = 0.6;  // s that a sentence must know of
constexpr double pause = 1;           // s, on the clock, before it comes again
constexpr double most_steps = 2e5;    // to be taken again in one frame
}  // namespace

void LossAgain::follow(const Playback& playback) {
  const GameRun* game = run_if<GameRun>(playback.simulation());
  const bool lost =
      game != nullptr && game->round().score.lost && game->settings().player == PlayerKind::human;
  if (!lost) return moments_.clear();
  if (moments_.empty() || lost_ != game->round().lost_clock) make(playback, *game);
  if (moments_.empty()) return;
  const double length = lost_ - begin_;
  const double since = std::max(0.0, game->round().clock - lost_);
  show(begin_ + std::min(length, rate * std::fmod(since, length / rate + pause)));
}

void LossAgain::make(const Playback& playback, const GameRun& game) {
  const Round& round = game.round();
  moments_.clear();
  lost_ = round.lost_clock;
  const double from = std::min(lost_ - lasts, round.touch_clock - before_touch);
  const Simulation* past = playback.past(std::max(from, lost_ - most_steps * game.dt()));
  if (past == nullptr) return;
  GameRun again = run_as<GameRun>(*past);
  again.repeat();
  moments_ = watch_again(std::move(again), lost_);
  sentence_ = to_sentence(loss_of(moments_, swing_speed(game.gravity()), game.gravity()));
  begin_ = std::max(moments_.front().t, lost_ - lasts);
}

void LossAgain::show(double t) {
  const auto later = std::find_if(moments_.begin(), moments_.end(),
                                  [t](const Moment& moment) { return moment.t > t; });
  at_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, later - moments_.begin()) - 1);
  now_ = between(moments_[at_], moments_[std::min(at_ + 1, moments_.size() - 1)], t);
  touch_ = moments_.size();
  for (std::size_t i = at_; i > 0 && moments_[i].t > begin_; --i) {
    if (moments_[i].push.isZero() && moments_[i].touches == moments_[i - 1].touches) {
      if (touch_ < moments_.size()) break;
      continue;
    }
    if (touch_ == moments_.size() || moments_[i].push.norm() > moments_[touch_].push.norm()) {
      touch_ = i;
    }
  }
}

std::vector<TrailPoint> LossAgain::trail() const {
  std::vector<TrailPoint> all;
  for (std::size_t i = at_ + 1; i-- > 0 && now_.t - moments_[i].t < trail_lasts;) {
    if (i % 4 == 0) all.push_back({now_.t - moments_[i].t, moments_[i].ball.position});
  }
  return all;
}

}  // namespace bounce
