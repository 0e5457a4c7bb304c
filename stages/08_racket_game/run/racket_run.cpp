#include "08_racket_game/run/racket_run.hpp"

#include "physics/integrators.hpp"
#include "run/saved_numbers.hpp"

namespace bounce {

// ---- Where it begins

void RacketRun::place(const std::vector<double>& values) {
  round_.ball = SavedNumbers(values).state<Eigen::Vector3d>();
  parameters_changed();
}

void RacketRun::parameters_changed() {
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

void RacketRun::reset_state() {
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

// ---- The bare physics: a racket in uniform motion, and the ball as it is seen from there

Racket RacketRun::bare_scene() const {
  Racket scene = full();
  scene.disc.normal = Plane::from_equation(normal_, 0).normal;
  scene.disc.velocity = velocity_;
  return scene;
}

Racket RacketRun::scene_at_rest() const {
  Racket scene = bare_scene();
  scene.disc.centre.setZero();
  scene.disc.velocity.setZero();
  begin_with(round_, scene);
  return scene;
}

RacketRun::Ball RacketRun::seen_from_racket(const Ball& ball, double t) const {
  const Disc disc = bare_scene().disc_at(t);
  return {ball.position - disc.centre, ball.velocity - disc.velocity};
}

RacketRun::Ball RacketRun::seen_from_ground(const Ball& ball, double t) const {
  const Disc disc = bare_scene().disc_at(t);
  return {ball.position + disc.centre, ball.velocity + disc.velocity};
}

// ---- Moving

void RacketRun::take_steps(long long count, double t, double dt) {
  if (is_game()) {
    for (long long i = 0; i < count; ++i) game_step(dt);
    return;
  }
  Racket scene = scene_at_rest();
  for (long long i = 0; i < count; ++i) move_ball(scene, 0, from_racket_, dt);
  end_with(round_, scene);
  round_.ball = seen_from_ground(from_racket_, t + static_cast<double>(count) * dt);
}

long long RacketRun::move_ball(Racket& scene, double t, Ball& ball, double dt) {
  const auto move = [&](const auto& make_step) {
    ContactSteps steps(scene, make_step);
    steps(t, ball, dt);
    pieces_ += steps.pieces;
    return steps.touches;
  };
  // The book is for the window: where none is kept, a step costs nothing more.
  const auto go = [&](const auto& make_step) {
    if (!keep_book_ || is_game()) return move(make_step);
    return move([&] {
      return [this, step = make_step()](const Racket& s, double now, Ball& x, double h) mutable {
        const Ball before = x;
        step(s, now, x, h);
        note_damper(s, now, before, x, h);
      };
    });
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
      return go(plain(
          [](const auto& s, double now, Ball& x, double h) { semi_implicit_euler(s, now, x, h); }));
  }
}

double RacketRun::go_by_events_towards(double t, long long most_events) {
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

// ---- The game

Disc RacketRun::disc() const {
  return is_game() ? disc_of(settings_, round_) : bare_scene().disc_at(time());
}

void RacketRun::want(Input input) {
  if (settings_.player != PlayerKind::human || is_replay()) return;
  input.assist = settings_.assist / 100;
  give(input);
}

void RacketRun::give(const Input& input) {
  take_input(round_, input);
  if (record_) record_->note(round_.steps, input);
}

void RacketRun::game_step(double dt) {
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

// ---- What others are compared with, and the books

void RacketRun::compare_from_here() {
  truth_.reset();
  truth_at_rim_.reset();
  if (is_game()) return;
  Racket scene = bare_scene();
  begin_with(round_, scene);
  book_ = {time(), round_.ball, energy().total(), 0};
  truth_.emplace(scene, time(), round_.ball);
  start_of_truth_ = reference_from_here(tightest);
}

std::optional<RacketReference> RacketRun::reference_from_here(double tolerance) const {
  if (is_game()) return std::nullopt;
  return std::optional<RacketReference>(std::in_place,
                                        RacketContacts(scene_at_rest(), from_racket_), time(),
                                        from_racket_, tolerance);
}

std::optional<RacketRun::Ball> RacketRun::truth_at(double t) const {
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

std::optional<RacketRun::Ball> RacketRun::exact_ball(double t) const {
  try {
    const std::optional<Ball> exact = truth_at(t);
    if (exact && bounce::is_finite(exact->position) && bounce::is_finite(exact->velocity))
      return exact;
  } catch (const TimeStandsStill&) {
  }
  return std::nullopt;
}

std::vector<double> RacketRun::exact_values(double t) const {
  const std::optional<Ball> exact = exact_ball(t);
  return exact ? numbers_of(*exact) : std::vector<double>{};
}

std::optional<StateError> RacketRun::error() const {
  const std::optional<Ball> exact = exact_ball(time());
  if (!exact) return std::nullopt;
  return StateError{distance_between(round_.ball.position, exact->position),
                    distance_between(round_.ball.velocity, exact->velocity)};
}

std::optional<double> RacketRun::exact_energy() const {
  const std::optional<Ball> exact = exact_ball(time());
  if (!exact) return std::nullopt;
  return bare_scene().energy(time(), *exact).total();
}

Energy RacketRun::energy() const {
  Racket scene = bare_scene();
  begin_with(round_, scene);
  scene.gravity = gravity();
  if (is_game()) scene.disc = disc();
  return scene.energy(is_game() ? scene.since : time(), round_.ball);
}

/// The damper's work over one step, by the midpoint rule.
void RacketRun::note_damper(const Racket& scene, double t, const Ball& before, const Ball& after,
                            double dt) {
  const Ball middle{(before.position + after.position) / 2, (before.velocity + after.velocity) / 2};
  book_.lost -= scene.damper_power(t + dt / 2, middle) * dt;
}

/// The energy at the start, and what the racket has given since. Its velocity u is constant, so
/// that the work of its force F on the ball is the integral of F.u, and F = m (v' - g):
///   work = m u.(v - v0 - g t)
double RacketRun::energy_before() const {
  if (is_game()) return energy().total();
  const Eigen::Vector3d gravity(0, -full().gravity, 0);
  const Eigen::Vector3d pushed =
      round_.ball.velocity - book_.ball.velocity - gravity * (time() - book_.start);
  return book_.energy + full().mass * velocity_.dot(pushed);
}

double RacketRun::energy_lost() const {
  if (is_game()) return 0;
  // Without steps there is no book: what is missing was lost.
  return goes_by_events(method()) ? energy_before() - energy().total() : book_.lost;
}

double RacketRun::next_event() const {
  if (is_game()) return never;
  if (method() == Method::reference) return reference_->next_event();
  return method() == Method::exact ? walk_->next_event() : never;
}

bool RacketRun::is_finite() const {
  return bounce::is_finite(round_.ball.position) && bounce::is_finite(round_.ball.velocity);
}

}  // namespace bounce
