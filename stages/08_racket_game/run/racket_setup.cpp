#include "08_racket_game/run/racket_setup.hpp"

namespace bounce {

std::vector<Parameter> RacketSetup::parameters() {
  std::vector<Parameter> all = racket.parameters();
  all[1].meaning = "pulls downwards; the game begins with 4 and grows up to this";
  Parameter normal = describe::normal(components(racket_normal));
  normal.name = "racket_normal";
  normal.meaning = "square to the disc, of any length; for the player none";
  all.insert(all.end() - 1, normal);
  all.insert(all.begin() + 2, {describe::position(components(start.position), 2),
                               describe::velocity(components(start.velocity))});
  Parameter velocity = describe::velocity(components(racket_velocity));
  velocity.name = "racket_velocity";
  velocity.meaning = "velocity x,y,z of the disc; for the player none";
  const std::vector<Parameter> of_run{
      velocity,
      {"mode",
       "",
       "what counts in the game: hits, landings in a ring, or hits on the beat, unseen",
       choice_of(mode, mode_names),
       {},
       {},
       true},
      {"assist", "%", "how much of the aim is taken off a human player", &assist, Range{0, 100},
       Range{0, 100}},
      {"strike", "", "the blind player's racket meets the ball while it slows down or speeds up",
       choice_of(strike, {"slowing", "speeding"})},
      {"knock", "m", "the blind player's ball starts higher by this", &knock, Range{-0.5, 1e3},
       Range{-0.3, 0.5}, true}};
  all.insert(all.end(), of_run.begin(), of_run.end());
  return all;
}

}  // namespace bounce
