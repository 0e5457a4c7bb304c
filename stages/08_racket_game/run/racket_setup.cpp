#include "08_racket_game/run/racket_setup.hpp"

#include "physics/components.hpp"

namespace bounce {

std::vector<Parameter> RacketSetup::parameters() {
  const auto named = [](const char* name, const char* meaning, Parameter parameter) {
    parameter.name = name;
    parameter.meaning = meaning;
    return parameter;
  };
  std::vector<Parameter> all{
      describe::mass(racket.mass),
      describe::gravity(racket.gravity),
      describe::position(components(start.position), 2),
      describe::velocity(components(start.velocity)),
      describe::radius(racket.radius),
      describe::stiffness(racket.stiffness),
      describe::damping(racket.damping),
      describe::contact(racket.contact),
      named("racket_position", "the disc's centre x,y,z at the start; in the game its home",
            describe::position(components(racket.disc.centre), 2)),
      named("racket_normal", "square to the disc, of any length; for the player none",
            describe::normal(components(racket_normal))),
      named("racket_radius", "of the disc; in the game it shrinks to half",
            describe::radius(racket.disc.radius)),
      named("racket_velocity", "velocity x,y,z of the disc; for the player none",
            describe::velocity(components(racket_velocity))),
      {"assist", "%", "how much of the aim is taken off a human player", &assist, Range{0, 100},
       Range{0, 100}},
      {"strike", "", "the blind player's racket meets the ball while it slows down or speeds up",
       choice_of(strike, {"slowing", "speeding"})},
      {"knock", "m", "the blind player's ball starts higher by this", &knock, Range{-0.5, 1e3},
       Range{-0.3, 0.5}, true}};
  for (Parameter& parameter : all) {
    if (parameter.name == "gravity") {
      parameter.meaning = "pulls downwards; the game begins with 4 and grows up to this";
    }
  }
  return all;
}

}  // namespace bounce
