#include "08_racket_game/game/game_run.hpp"

#include <cmath>

#include "08_racket_game/game/round_step.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "physics/remembered.hpp"
#include "run/rows.hpp"

namespace bounce {

// ---- What it is

/// The same as for the bare physics, so that the two that are not for a game can be refused in
/// words.
std::vector<Method> GameRun::methods() const {
  std::vector<Method> all = AnyMethod<Methods>::offered();
  all.insert(all.end(), {methods::reference, methods::exact});
  return all;
}

Traits GameRun::traits() const {
  const std::string& player = player_names[static_cast<std::size_t>(settings_.player)];
  Traits all{"x,y,z,vx,vy,vz", settings_.contact_numbers()};
  all.cuts_steps = true;
  all.pieces_per_step =
      std::max({1.0, dt() / longest_contact_piece(settings_.racket), dt() / longest_step});
  all.summary = "player=" + player + " hits=" + std::to_string(round_.score.hits) +
                " lost=" + (round_.score.lost ? "yes" : "no");
  if (settings_.counts_points()) all.summary += " points=" + std::to_string(round_.points.total);
  if (settings_.player != PlayerKind::human) all.command = " --player " + player;
  all.saved_options = {{"player", player}};
  return all;
}

std::vector<double> GameRun::values() const {
  NumberWriter row;
  row("ball", round_.ball);
  return row.take();
}

// ---- Where it begins

void GameRun::reset_state() {
  if (method().goes_by_events) {
    throw BadInput("--method " + name_of(method()) +
                   " is not allowed in the game: it must be a stepping method, or "
                   "--player none, where the racket's movement is known beforehand");
  }
  settings_.seed = seed();
  round_ = begin_round(settings_, round_);
  more_pieces_ = 0;
  next_entry_ = 0;
  if (record_) note_settings();
  parameters_changed();
}

void GameRun::place(const std::vector<double>& values) {
  read_rows(values, round_.ball);
  parameters_changed();
}

void GameRun::parameters_changed() {
  Racket scene = scene_now();
  // Put through the disc by hand, it is on the other side.
  const double depth = scene.radius - scene.side * scene.disc.height(round_.ball.position);
  if (time() == 0 || depth > 2 * scene.radius) scene.start_side(0, round_.ball.position);
  scene.choose_side(0, round_.ball.position);
  round_.side = scene.side;
  round_.through = scene.through;
  method_.begin(method());
}

// ---- Moving

bool GameRun::take_steps(long long count, double /*t*/, double dt) {
  for (long long i = 0; i < count; ++i) one_step(dt);
  return is_finite(round_.ball.position) && is_finite(round_.ball.velocity);
}

void GameRun::one_step(double dt) {
  --more_pieces_;  // this step itself
  if (replay_) {
    const auto& all = replay_->entries;
    while (next_entry_ < all.size() && all[next_entry_].step <= round_.steps) {
      take_input(round_, all[next_entry_++].input);
    }
  } else if (settings_.player == PlayerKind::autopilot &&
             (round_.steps == 0 || round_.input_age >= rules::input_time)) {
    give(autopilot(view_of(settings_, round_)));
  }
  const double parts = std::ceil(dt / longest_step - 1e-9);
  if (parts > 1e6) {
    throw TimeStandsStill(round_.clock, "a step of the game would be cut into more than 1e6",
                          "take a shorter --dt");
  }
  const auto move_ball = [this](Racket& scene, Ball& ball, double h) {
    const RacketStep taken =
        method_.visit([&](auto& method) { return racket_step(method, scene, 0, ball, h); });
    more_pieces_ += taken.pieces;
    return taken.touches;
  };
  for (double part = 0; part < parts; ++part) step(settings_, round_, dt / parts, move_ball);
}

// ---- Inputs: of a human, from a file, and noted for one

void GameRun::want(Input input) {
  if (settings_.player != PlayerKind::human || is_replay()) return;
  input.assist = settings_.assist / 100;
  give(input);
}

void GameRun::use_next_mode() {
  const std::size_t next = (settings_.mode + std::size_t{1}) % mode_names.size();
  find_parameter(parameters(), "mode").set(mode_names[next]);
  round_.points.best = 0;  // that was of the mode before
}

void GameRun::give(const Input& input) {
  take_input(round_, input);
  if (record_) record_->note(round_.steps, input);
}

void GameRun::replay(std::shared_ptr<const InputLog> log) {
  replay_ = std::move(log);
  for (const auto& [name, value] : replay_->parameters) {
    find_parameter(parameters(), name).set(value);
  }
  settings_.player = PlayerKind::human;
  use_seed(replay_->seed);
  round_.number = replay_->round;
  use_method(find_method(replay_->method, methods()));
  use_dt(replay_->dt);
}

void GameRun::repeat() {
  if (!record_ || replay_) return;
  replay_ = std::exchange(record_, nullptr);
  const auto& all = replay_->entries;
  next_entry_ = 0;
  while (next_entry_ < all.size() && all[next_entry_].step < round_.steps) ++next_entry_;
}

void GameRun::note_settings() {
  *record_ = {
      .seed = settings_.seed, .round = round_.number, .dt = dt(), .method = name_of(method())};
  for (const Parameter& parameter : parameters()) {
    record_->parameters.emplace_back(parameter.name, parameter.text());
  }
}

// ---- Saving and loading

template <class Self, class Visit>
void GameRun::remembered(Self& self, Visit& visit) {
  visit.whole("player", self.settings_.player, 0, 3);
  visit.whole("seed", self.settings_.seed, 0, 1'000'000'000'000'000);
  visit.whole("next_entry", self.next_entry_, 0, 1'000'000'000'000'000);
  Round::remembered(self.round_, visit);
  if (self.settings_.counts_points()) Points::remembered(self.round_.points, visit);
}

std::vector<double> GameRun::numbers() const {
  NumberWriter writer;
  remembered(*this, writer);
  return writer.take();
}

std::string GameRun::recall_numbers(const std::vector<double>& all) {
  if (method().goes_by_events) return "the method";
  NumberReader reader(all);
  remembered(*this, reader);
  use_seed(settings_.seed);
  return reader.trouble();
}

}  // namespace bounce
