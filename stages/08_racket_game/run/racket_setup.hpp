#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "08_racket_game/racket_game.hpp"
#include "run/simulation.hpp"

namespace bounce {

inline const std::vector<std::string> mode_names{"keep-up", "target", "blind"};

/// Everything about stage 8 that can be set, for the game and for the bare physics alike.
struct RacketSetup {
  Racket racket;  // its disc: home, first radius; its gravity: the full one
  State<Eigen::Vector3d> start{{0, 1, 0}, {0, 0, 0}};  // m, m/s; in the game the serve is added
  // Of the bare physics
  Eigen::Vector3d racket_normal{0, 1, 0};    // any length
  Eigen::Vector3d racket_velocity{0, 0, 0};  // m/s
  // Of the game
  enum { keep_up, target, blind } mode = keep_up;  // what counts: mode_names
  double assist = 30;                              // %
  double knock = 0.2;                              // m, for the blind player's ball
  enum { slowing, speeding } strike = slowing;     // how the blind player's racket meets the ball

  std::vector<Parameter> parameters();

  SpringDamper contact() const { return {racket.stiffness, racket.damping, racket.contact}; }
  double restitution() const { return bounce::restitution(contact(), racket.mass); }
  /// How long a hit takes [s]; a ball that would stay for ever counts as one for a moment.
  double hit_time() const { return std::min(contact_time(contact(), racket.mass), 0.2); }
  ContactNumbers contact_numbers() const {
    return {natural_frequency(racket.stiffness, racket.mass),
            damping_ratio(racket.stiffness, racket.damping, racket.mass), racket.contact};
  }
};

}  // namespace bounce
