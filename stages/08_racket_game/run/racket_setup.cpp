// How RacketRun is set up, and what it says of itself.

#include "08_racket_game/run/racket_run.hpp"

namespace bounce {

std::vector<Parameter> RacketRun::parameters() {
  Racket& racket = settings_.racket;
  const auto named = [](const char* name, const char* meaning, Parameter parameter) {
    parameter.name = name;
    parameter.meaning = meaning;
    return parameter;
  };
  std::vector<Parameter> all{
      describe::mass(racket.mass),
      describe::gravity(racket.gravity),
      describe::position(components(settings_.start.position), 2),
      describe::velocity(components(settings_.start.velocity)),
      describe::radius(racket.radius),
      describe::stiffness(racket.stiffness),
      describe::damping(racket.damping),
      describe::contact(racket.contact),
      named("racket_position", "the disc's centre x,y,z at the start; in the game its home",
            describe::position(components(racket.disc.centre), 2)),
      named("racket_normal", "square to the disc, of any length; for the player none",
            describe::normal(components(normal_))),
      named("racket_radius", "of the disc; in the game it shrinks to half",
            describe::radius(racket.disc.radius)),
      named("racket_velocity", "velocity x,y,z of the disc; for the player none",
            describe::velocity(components(velocity_))),
      {"assist", "%", "how much of the aim is taken off a human player", &settings_.assist,
       Range{0, 100}, Range{0, 100}},
      {"strike", "", "the blind player's racket meets the ball while it slows down or speeds up",
       choice_of(settings_.strike, {"slowing", "speeding"})},
      {"knock", "m", "the blind player's ball starts higher by this", &settings_.knock,
       Range{-0.5, 1e3}, Range{-0.3, 0.5}, true}};
  for (Parameter& parameter : all) {
    if (parameter.name == "gravity") {
      parameter.meaning = "pulls downwards; the game begins with 4 and grows up to this";
    }
  }
  return all;
}

std::vector<Method> RacketRun::methods() const {
  return {Method::explicit_euler,  Method::semi_implicit_euler,
          Method::velocity_verlet, Method::rk4,
          Method::reference,       Method::exact};
}

std::optional<ContactNumbers> RacketRun::contact() const {
  return ContactNumbers{natural_frequency(full().stiffness, full().mass),
                        damping_ratio(full().stiffness, full().damping, full().mass)};
}

double RacketRun::pieces_per_step() const {
  const double in_contact = dt() / longest_contact_piece(full());
  return std::max({1.0, in_contact, is_game() ? dt() / longest_game_step : 0});
}

long long RacketRun::counted_force_evaluations() const {
  if (method() == Method::reference) return reference_ ? reference_->force_evaluations() : 0;
  return (pieces_ - steps()) * force_evaluations_per_step(method());
}

std::string RacketRun::summary() const {
  static constexpr const char* names[] = {"human", "autopilot", "blind", "idle", "none"};
  std::string words = std::string("player=") + names[static_cast<int>(settings_.player)];
  if (!is_game()) return words;
  return words + " hits=" + std::to_string(round_.score.hits) +
         " lost=" + (round_.score.lost ? "yes" : "no");
}

std::string RacketRun::stage_options() const {
  static constexpr const char* words[] = {"", " --player autopilot", " --player blind",
                                          " --player idle", " --player none"};
  return words[static_cast<int>(settings_.player)];
}

// ---- Inputs: from a file, and noted for one

void RacketRun::replay(std::shared_ptr<const InputLog> log) {
  replay_ = std::move(log);
  for (const auto& [name, value] : replay_->parameters) {
    find_parameter(parameters(), name).set(value);
  }
  settings_.player = PlayerKind::human;
  settings_.seed = replay_->seed;
  round_.number = replay_->round;
  use_method(find_method(replay_->method, methods()));
  use_dt(replay_->dt);
}

void RacketRun::note_settings() {
  record_->entries.clear();
  record_->seed = settings_.seed;
  record_->round = round_.number;
  record_->dt = dt();
  record_->method = name_of(method());
  record_->parameters.clear();
  for (const Parameter& parameter : parameters()) {
    record_->parameters.emplace_back(parameter.name, parameter.text());
  }
}

}  // namespace bounce
