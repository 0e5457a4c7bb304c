#pragma once
#include <string>
#include <vector>

#include "08_racket_game/game/loss.hpp"
#include "08_racket_game/picture/court_drawing.hpp"
#include "app/playback.hpp"

namespace bounce {

/// After a loss its last three seconds are shown again and again, at a quarter of the speed.
class LossAgain {
 public:
  static constexpr double lasts = 3;    // s
  static constexpr double rate = 0.25;  // of real time

  /// Once a picture. Makes the round's end anew when it is a new one.
  void follow(const Playback& playback);

  bool is_on() const { return !moments_.empty(); }
  const std::string& sentence() const { return sentence_; }
  const Moment& now() const { return now_; }
  /// The moment of the strongest push so far, since the ball was last free; nullptr before.
  const Moment* touch() const { return touch_ < moments_.size() ? &moments_[touch_] : nullptr; }
  std::vector<TrailPoint> trail() const;

 private:
  void make(const Playback& playback, const GameRun& game);
  void show(double t);

  std::vector<Moment> moments_;
  std::string sentence_;
  double begin_ = 0;                // of what is shown [s]
  double lost_ = -1;                // when [s]
  std::size_t at_ = 0, touch_ = 0;  // in moments_
  Moment now_{};
};

}  // namespace bounce
