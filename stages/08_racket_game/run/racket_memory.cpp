// What RacketRun remembers, for `--save` and `--load`.

#include <type_traits>

#include "08_racket_game/run/racket_run.hpp"
#include "run/saved_numbers.hpp"

namespace bounce {
namespace {

/// Calls `visit` with every number that a round consists of besides the ball.
template <class Visit>
void each_number(Round& round, const Visit& visit) {
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

constexpr auto most_count = static_cast<long long>(Simulation::valid_count.highest);

template <class Number>
void take(SavedNumbers& saved, Number& number) {
  if constexpr (std::is_same_v<Number, bool>) {
    number = saved.whole(0, 1) == 1;
  } else if constexpr (std::is_integral_v<Number>) {
    constexpr long long most = sizeof(Number) < 8 ? 2'000'000'000 : most_count;
    number = static_cast<Number>(saved.whole(-most, most));
  } else {
    number = saved.number();
  }
}

}  // namespace

std::vector<double> RacketRun::numbers() const {
  std::vector<double> all;
  const auto append_number = [&all](auto number) { all.push_back(static_cast<double>(number)); };
  append(all, round_.ball);
  append(all, from_racket_);
  Round round = round_;
  each_number(round, append_number);
  append_number(next_entry_);
  append_number(settings_.player);
  append_number(settings_.seed);
  if (method() == Method::reference && reference_) {
    append_number(reference_->next_step());
    append_number(reference_->piece_start());
    append(all, reference_->state_at_piece_start());
    append_number(reference_->contacts().place());
    append_number(reference_->contacts().phase());
  }
  if (method() == Method::exact && walk_) {
    append_number(walk_->walker().last_event());
    append(all, walk_->walker().state_at_last_event());
    append_number(walk_->walker().phase());
  }
  return all;
}

bool RacketRun::recall_numbers(const std::vector<double>& all) {
  SavedNumbers saved(all);
  round_.ball = saved.state<Eigen::Vector3d>();
  from_racket_ = saved.state<Eigen::Vector3d>();
  each_number(round_, [&](auto& number) { take(saved, number); });
  next_entry_ = static_cast<std::size_t>(saved.whole(0, most_count));
  settings_.player = static_cast<PlayerKind>(saved.whole(0, 4));
  settings_.seed = static_cast<std::uint64_t>(saved.whole(0, most_count));
  if (is_game() && goes_by_events(method())) return false;
  if (method() == Method::reference) return recall_reference(saved);
  if (method() == Method::exact) return recall_walk(saved);
  return saved.all_is_well();
}

bool RacketRun::recall_reference(SavedNumbers& saved) {
  const double step = saved.positive(), since = saved.number();
  const Ball at_start = saved.state<Eigen::Vector3d>();
  const auto place = static_cast<RacketContacts::Place>(saved.whole(0, 2));
  const Phase phase = saved.phase();
  if (!saved.all_is_well()) return false;
  reference_ = reference_from_here(tolerance());
  reference_->resume({scene_at_rest(), phase, place}, since, at_start, step);
  return true;
}

bool RacketRun::recall_walk(SavedNumbers& saved) {
  const double since = saved.number();
  const Ball at_start = saved.state<Eigen::Vector3d>();
  const Phase phase = saved.phase();
  if (!saved.all_is_well()) return false;
  Racket scene = bare_scene();
  begin_with(round_, scene);
  walk_.emplace(scene, time(), round_.ball);
  walk_->resume(since, at_start, phase);
  return true;
}

}  // namespace bounce
