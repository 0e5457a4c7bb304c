#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "contact_steps.hpp"
#include "input_log.hpp"
#include "physics/components.hpp"
#include "physics/integrators.hpp"
#include "racket_contacts.hpp"
#include "round.hpp"
#include "run/simulation.hpp"
#include "walk.hpp"

namespace bounce {

/// Stage 8 as a simulation: a round of the game, or (`--player none`) the bare physics of a ball
/// and a racket in uniform motion.
class RacketRun final : public Simulation {
 public:
  using Ball = State<Eigen::Vector3d>;

  RacketRun() { reset_state(); }

  // ---- What pictures and players need to know
  const Settings& settings() const { return settings_; }
  const Round& round() const { return round_; }
  bool is_game() const { return settings_.player != PlayerKind::none; }
  bool is_replay() const { return replay_ != nullptr; }
  double gravity() const { return is_game() ? gravity_of(settings_, round_) : full().gravity; }
  Disc disc() const {
    return is_game() ? disc_of(settings_, round_) : bare_scene().disc_at(time());
  }
  double floor_height() const { return full().disc.centre.y() - rules::floor_below; }

  // ---- How it is played
  void play_as(PlayerKind player) { settings_.player = player; }
  void keep_best(int best) { round_.score.best = std::max(round_.score.best, best); }
  void set_assist(double percent) { settings_.assist = std::clamp(percent, 0.0, 100.0); }
  /// A human's input, once a frame.
  void want(Input input) {
    if (settings_.player != PlayerKind::human || is_replay()) return;
    input.assist = settings_.assist / 100;
    give(input);
  }
  /// Notes all inputs in `log`.
  void record(std::shared_ptr<InputLog> log) { record_ = std::move(log); }
  /// Plays the inputs of `log`, with what else is written there.
  void replay(std::shared_ptr<const InputLog> log) {
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

  // ---- As every simulation
  std::unique_ptr<Simulation> clone() const override { return std::make_unique<RacketRun>(*this); }
  std::vector<Parameter> parameters() override;
  std::vector<Method> methods() const override {
    return {Method::explicit_euler,  Method::semi_implicit_euler,
            Method::velocity_verlet, Method::rk4,
            Method::reference,       Method::exact};
  }
  std::vector<std::string> columns() const override { return {"x", "y", "z", "vx", "vy", "vz"}; }
  std::vector<double> values() const override { return ball_numbers(round_.ball); }
  std::vector<double> exact_values(double t) const override {
    const std::optional<Ball> exact = exact_ball(t);
    return exact ? ball_numbers(*exact) : std::vector<double>{};
  }
  std::optional<ContactNumbers> contact() const override {
    return ContactNumbers{natural_frequency(full().stiffness, full().mass),
                          damping_ratio(full().stiffness, full().damping, full().mass)};
  }
  bool cuts_steps() const override { return true; }
  double pieces_per_step() const override {
    const double in_contact = dt() / longest_contact_piece(full());
    return std::max({1.0, in_contact, is_game() ? dt() / longest_game_step : 0});
  }
  long long counted_force_evaluations() const override {
    if (method() == Method::reference) return reference_ ? reference_->force_evaluations() : 0;
    return (pieces_ - steps()) * force_evaluations_per_step(method());
  }
  std::string summary() const override;
  std::string stage_options() const override;
  void use_seed(std::uint64_t seed) override { settings_.seed = seed; }
  std::optional<StateError> error() const override {
    const std::optional<Ball> exact = exact_ball(time());
    if (!exact) return std::nullopt;
    return StateError{distance_between(round_.ball.position, exact->position),
                      distance_between(round_.ball.velocity, exact->velocity)};
  }
  void place(const std::vector<double>& values) override {
    round_.ball = ball_from(values, 0);
    parameters_changed();
  }
  void parameters_changed() override {
    Racket scene = full();
    scene.disc = disc();
    scene.since = time();
    begin_with(round_, scene);
    // Put through the disc by hand, it is on the other side.
    const double depth = scene.radius - scene.side * scene.disc.height(round_.ball.position);
    if (time() == 0 || depth > 2 * scene.radius) {
      scene.start_side(time(), round_.ball.position);
    }
    scene.choose_side(time(), round_.ball.position);
    end_with(round_, scene);
    from_racket_ = seen_from_racket(round_.ball, time());
    compare_from_here();
    walk_ = truth_;
    reference_ = reference_from_here(tolerance());
  }
  double next_event() const override {
    if (is_game()) return never;
    if (method() == Method::reference) return reference_->next_event();
    return method() == Method::exact ? walk_->next_event() : never;
  }
  Energy energy() const override {
    Racket scene = bare_scene();
    begin_with(round_, scene);
    scene.gravity = gravity();
    if (is_game()) scene.disc = disc();
    return scene.energy(is_game() ? scene.since : time(), round_.ball);
  }
  // What the racket gives and the damper takes is not told apart: no book is kept.
  void keep_energy_book(bool /*keep*/) override {}
  double energy_before() const override { return energy().total(); }
  double energy_lost() const override { return 0; }
  std::optional<double> exact_energy() const override {
    const std::optional<Ball> exact = exact_ball(time());
    if (!exact) return std::nullopt;
    return bare_scene().energy(time(), *exact).total();
  }

 protected:
  void reset_state() override {
    if (is_game() && goes_by_events(method())) {
      throw BadInput("--method " + name_of(method()) +
                     " is not allowed in the game: it must be a stepping method, or "
                     "--player none, where the racket's movement is known beforehand");
    }
    const int next = round_.number + (round_.score.lost ? 1 : 0);
    round_ = begin_round(settings_, next, round_.score.best);
    pieces_ = 0;
    next_entry_ = 0;
    if (record_) note_settings();
    parameters_changed();
  }
  void compare_from_here() override {
    truth_.reset();
    truth_at_rim_.reset();
    if (is_game()) return;
    Racket scene = bare_scene();
    begin_with(round_, scene);
    truth_.emplace(scene, time(), round_.ball);
    start_of_truth_ = reference_from_here(tightest);
  }
  void take_steps(long long count, double t, double dt) override {
    if (is_game()) {
      for (long long i = 0; i < count; ++i) game_step(dt);
      return;
    }
    Racket scene = scene_at_rest();
    for (long long i = 0; i < count; ++i) move_ball(scene, 0, from_racket_, dt);
    end_with(round_, scene);
    round_.ball = seen_from_ground(from_racket_, t + static_cast<double>(count) * dt);
  }
  double go_by_events_towards(double t, long long most_events) override {
    if (is_game()) return t;
    double reached = t;
    Racket scene = scene_at_rest();
    if (method() == Method::reference) {
      if (!reference_->reach(t, most_events)) reached = reference_->piece_start();
      from_racket_ = reference_->at(reached);
      round_.ball = seen_from_ground(from_racket_, reached);
      scene.side = reference_->contacts().side();
      scene.through = reference_->contacts().place() == RacketContacts::Place::beyond;
    } else {
      if (!walk_->reach(t, most_events)) reached = walk_->walker().last_event();
      round_.ball = walk_->at(reached);
      from_racket_ = seen_from_racket(round_.ball, reached);
      // In contact the side is that of the touch.
      const bool flies = walk_->walker().phase() == Phase::flight;
      const Ball& seen = flies ? from_racket_ : walk_->walker().state_at_last_event();
      scene.start_side(0, seen.position);
    }
    end_with(round_, scene);
    return reached;
  }
  bool is_finite() const override {
    return bounce::is_finite(round_.ball.position) && bounce::is_finite(round_.ball.velocity);
  }
  std::vector<double> numbers() const override;
  bool recall_numbers(const std::vector<double>& all) override;

 private:
  const Racket& full() const { return settings_.racket; }

  /// The racket of the bare physics: at time 0, in uniform motion.
  Racket bare_scene() const {
    Racket scene = full();
    scene.disc.normal = Plane::from_equation(normal_, 0).normal;
    scene.disc.velocity = velocity_;
    return scene;
  }

  /// The same, seen from the racket: nothing in a contact depends on who watches.
  Racket scene_at_rest() const {
    Racket scene = bare_scene();
    scene.disc.centre.setZero();
    scene.disc.velocity.setZero();
    begin_with(round_, scene);
    return scene;
  }
  std::optional<RacketReference> reference_from_here(double tolerance) const {
    if (is_game()) return std::nullopt;
    return std::optional<RacketReference>(std::in_place,
                                          RacketContacts(scene_at_rest(), from_racket_), time(),
                                          from_racket_, tolerance);
  }

  Ball seen_from_racket(const Ball& ball, double t) const {
    const Disc disc = bare_scene().disc_at(t);
    return {ball.position - disc.centre, ball.velocity - disc.velocity};
  }
  Ball seen_from_ground(const Ball& ball, double t) const {
    const Disc disc = bare_scene().disc_at(t);
    return {ball.position + disc.centre, ball.velocity + disc.velocity};
  }

  /// Returns the number of new touches.
  long long move_ball(Racket& scene, double t, Ball& ball, double dt) {
    const auto go = [&](const auto& make_step) {
      ContactSteps steps(scene, make_step);
      steps(t, ball, dt);
      pieces_ += steps.pieces;
      return steps.touches;
    };
    const auto plain = [](auto method) { return [method] { return method; }; };
    switch (method()) {
      case Method::explicit_euler:
        return go(plain(
            [](const auto& s, double now, Ball& x, double h) { explicit_euler(s, now, x, h); }));
      case Method::velocity_verlet:
        return go([] { return VelocityVerlet<Eigen::Vector3d>{}; });
      case Method::rk4:
        return go(plain([](const auto& s, double now, Ball& x, double h) { rk4(s, now, x, h); }));
      default:
        return go(plain([](const auto& s, double now, Ball& x, double h) {
          semi_implicit_euler(s, now, x, h);
        }));
    }
  }

  void game_step(double dt) {
    if (replay_) {
      for (; next_entry_ < replay_->entries.size() &&
             replay_->entries[next_entry_].step <= round_.steps;
           ++next_entry_) {
        take_input(round_, replay_->entries[next_entry_].input);
      }
    } else if (settings_.player == PlayerKind::autopilot &&
               (round_.steps == 0 || round_.input_age >= rules::input_time)) {
      give(autopilot(sight_of(settings_, round_)));
    }
    const double parts = std::ceil(dt / longest_game_step - 1e-9);
    if (parts > 1e6) {
      throw TimeStandsStill(round_.clock, "a step of the game would be cut into more than 1e6",
                            "take a shorter --dt");
    }
    for (double part = 0; part < parts; ++part) {
      step(settings_, round_, dt / parts,
           [this](Racket& scene, Ball& ball, double h) { return move_ball(scene, 0, ball, h); });
    }
  }

  void give(const Input& input) {
    take_input(round_, input);
    if (record_) record_->note(round_.steps, input);
  }

  void note_settings() {
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

  std::optional<Ball> exact_ball(double t) const {
    try {
      const std::optional<Ball> exact = truth_at(t);
      if (exact && bounce::is_finite(exact->position) && bounce::is_finite(exact->velocity))
        return exact;
    } catch (const TimeStandsStill&) {
    }
    return std::nullopt;
  }
  /// The closed form as far as it goes, and then the reference.
  std::optional<Ball> truth_at(double t) const {
    if (truth_) {
      try {
        if (truth_->reach(t, most_events_of_truth)) {
          return truth_->at(std::max(t, truth_->walker().last_event()));
        }
        truth_.reset();
      } catch (const NoClosedForm&) {
        truth_.reset();
        truth_at_rim_ = start_of_truth_;
      }
    }
    if (!truth_at_rim_) return std::nullopt;
    if (!truth_at_rim_->reach(t, most_events_of_truth)) {
      truth_at_rim_.reset();
      return std::nullopt;
    }
    const double shown = std::max(t, truth_at_rim_->piece_start());
    return seen_from_ground(truth_at_rim_->at(shown), shown);
  }

  // A hand and a racket are followed in steps of 5 ms at most.
  static constexpr double longest_game_step = 5e-3;
  // Of the reference that others are compared with
  static constexpr double tightest = 1e-14;
  // A comparison is worth a second or two, not an hour.
  static constexpr long long most_events_of_truth = 5000000;

  static std::vector<double> ball_numbers(const Ball& ball) {
    const auto& [p, v] = ball;
    return {p.x(), p.y(), p.z(), v.x(), v.y(), v.z()};
  }
  static Ball ball_from(const std::vector<double>& all, std::size_t i) {
    return {{all.at(i), all.at(i + 1), all.at(i + 2)},
            {all.at(i + 3), all.at(i + 4), all.at(i + 5)}};
  }
  /// Calls `visit` with every number that a round consists of besides the ball.
  template <class Visit>
  static void each_number(Round& round, const Visit& visit);

  Settings settings_;
  Eigen::Vector3d normal_{0, 1, 0};    // of the bare physics' racket, any length
  Eigen::Vector3d velocity_{0, 0, 0};  // m/s
  std::shared_ptr<InputLog> record_;
  std::shared_ptr<const InputLog> replay_;
  std::size_t next_entry_ = 0;

  Round round_;
  Ball from_racket_ = round_.ball;  // the bare physics' ball, seen from the racket
  long long pieces_ = 0;
  std::optional<RacketWalk> walk_;            // the movement, for `exact`
  std::optional<RacketReference> reference_;  // the same, for `reference`
  // What all others are compared with; the reference from the start on, once the rim is reached
  mutable std::optional<RacketWalk> truth_;
  std::optional<RacketReference> start_of_truth_;
  mutable std::optional<RacketReference> truth_at_rim_;
};

inline std::vector<Parameter> RacketRun::parameters() {
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

inline std::string RacketRun::summary() const {
  static constexpr const char* names[] = {"human", "autopilot", "blind", "idle", "none"};
  std::string words = std::string("player=") + names[static_cast<int>(settings_.player)];
  if (!is_game()) return words;
  return words + " hits=" + std::to_string(round_.score.hits) +
         " lost=" + (round_.score.lost ? "yes" : "no");
}

inline std::string RacketRun::stage_options() const {
  static constexpr const char* words[] = {"", " --player autopilot", " --player blind",
                                          " --player idle", " --player none"};
  return words[static_cast<int>(settings_.player)];
}

template <class Visit>
void RacketRun::each_number(Round& round, const Visit& visit) {
  for (Follower* follower :
       {&round.grip.x, &round.grip.y, &round.grip.z, &round.grip.lean_x, &round.grip.lean_z}) {
    visit(follower->position);
    visit(follower->velocity);
  }
  for (Input* input : {&round.from, &round.to}) {
    for (double* number :
         {&input->x, &input->z, &input->tilt_x, &input->tilt_z, &input->swing, &input->assist}) {
      visit(*number);
    }
  }
  visit(round.input_age);
  visit(round.clock);
  visit(round.lost_clock);
  visit(round.touch_speed);
  visit(round.touch_clock);
  for (double& number : components(round.touch_place)) visit(number);
  visit(round.side);
  visit(round.through);
  visit(round.steps);
  visit(round.number);
  visit(round.touches);
  visit(round.score.hits);
  visit(round.score.best);
  visit(round.score.touched);
  visit(round.score.lost);
}

inline std::vector<double> RacketRun::numbers() const {
  std::vector<double> all = ball_numbers(round_.ball);
  for (const double number : ball_numbers(from_racket_)) all.push_back(number);
  Round round = round_;
  each_number(round, [&](auto& number) { all.push_back(static_cast<double>(number)); });
  all.push_back(static_cast<double>(next_entry_));
  all.push_back(static_cast<double>(settings_.player));
  all.push_back(static_cast<double>(settings_.seed));
  if (method() == Method::reference && reference_) {
    all.push_back(reference_->next_step());
    all.push_back(reference_->piece_start());
    for (const double number : ball_numbers(reference_->state_at_piece_start())) {
      all.push_back(number);
    }
    all.push_back(static_cast<double>(reference_->contacts().place()));
    all.push_back(static_cast<double>(reference_->contacts().phase()));
  }
  if (method() == Method::exact && walk_) {
    all.push_back(walk_->walker().last_event());
    for (const double number : ball_numbers(walk_->walker().state_at_last_event())) {
      all.push_back(number);
    }
    all.push_back(static_cast<double>(walk_->walker().phase()));
  }
  return all;
}

inline bool RacketRun::recall_numbers(const std::vector<double>& all) {
  std::size_t expected = 15;
  each_number(round_, [&](auto&) { ++expected; });
  const bool exact = method() == Method::exact, reference = method() == Method::reference;
  if (all.size() != expected + (exact ? 8 : reference ? 10 : 0)) return false;
  // Every count must fit into its type, and the side, the player and the flags be what they are.
  std::size_t at = 12;
  bool fits = true;
  each_number(round_, [&](auto& number) {
    using Number = std::remove_reference_t<decltype(number)>;
    const double value = all[at++];
    if constexpr (std::is_same_v<Number, bool>) {
      fits = fits && (value == 0 || value == 1);
    } else if constexpr (std::is_integral_v<Number>) {
      fits = fits && std::abs(value) <= (sizeof(Number) < 8 ? 2e9 : 1e18);
    }
  });
  const double entry = all[at], player = all[at + 1], seed = all[at + 2];
  if (!fits || !(entry >= 0 && entry <= 1e18) || !(player >= 0 && player <= 4) ||
      !(seed >= 0 && seed <= 1e18)) {
    return false;
  }
  round_.ball = ball_from(all, 0);
  from_racket_ = ball_from(all, 6);
  std::size_t i = 12;
  each_number(round_, [&](auto& number) {
    number = static_cast<std::remove_reference_t<decltype(number)>>(all[i++]);
  });
  next_entry_ = static_cast<std::size_t>(all[i++]);
  settings_.player = static_cast<PlayerKind>(static_cast<int>(all[i++]));
  settings_.seed = static_cast<std::uint64_t>(all[i++]);
  if (!exact && !reference) return true;
  const double phase = all.back();
  if (!(phase == 0 || phase == 1 || phase == 2) || is_game()) return false;
  if (reference) {
    const double step = all[i], place = all[i + 8];
    if (!(step > 0) || !(place == 0 || place == 1 || place == 2)) return false;
    reference_ = reference_from_here(tolerance());
    reference_->resume({scene_at_rest(), static_cast<Phase>(static_cast<int>(phase)),
                        static_cast<RacketContacts::Place>(static_cast<int>(place))},
                       all[i + 1], ball_from(all, i + 2), step);
    return true;
  }
  Racket scene = bare_scene();
  begin_with(round_, scene);
  walk_.emplace(scene, time(), round_.ball);
  walk_->resume(all[i], ball_from(all, i + 1), static_cast<Phase>(static_cast<int>(phase)));
  return true;
}

}  // namespace bounce
