#include "run/error_chart.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace bounce {
namespace {

constexpr std::size_t samples = 50;
constexpr double no_number = std::numeric_limits<double>::infinity();
constexpr int steps_per_method = 6;          // half a power of ten apart
constexpr double most_steps_of_a_run = 2e5;  // for one ball
constexpr std::size_t most_balls = 9;        // beyond that the chart would take too long
constexpr double longest_run = 20;           // simulated seconds
constexpr double bounces = 4;                // in a run, about
constexpr double without_bounces = 2;        // simulated seconds

std::string setting_of(const Simulation& simulation) {
  const std::unique_ptr<Simulation> copy = simulation.clone();  // parameters() may change it
  std::string all = copy->traits().command;
  for (const Parameter& parameter : copy->parameters()) {
    all += " " + parameter.name + "=" + parameter.text();
  }
  return all;
}

/// The largest 1 x 10^n or 3 x 10^n up to `value`.
double round_step(double value) {
  const double n = std::floor(std::log10(value));
  // Of 10^3 every C library gives the nearest number, of 10^-3 not (Windows').
  const double power = n < 0 ? 1 / std::pow(10, -n) : std::pow(10, n);
  return value >= 3 * power ? 3 * power : power;
}

}  // namespace

void ErrorChart::follow(const Simulation& simulation, int patience) {
  const std::string setting = setting_of(simulation);
  stood_still_ = setting == seen_ ? stood_still_ + 1 : 0;
  seen_ = setting;
  if (setting != setting_) {
    if (stood_still_ < patience) return;
    setting_ = setting;
    start_anew(simulation);
  }
  const Choice now{simulation.method(), simulation.dt()};
  if (now_ == now) return;
  now_ = now;
  own_.reset();
}

std::optional<ErrorChart::Dot> ErrorChart::now() const {
  if (own_) return own_;
  for (const Dot& dot : dots_) {
    if (now_ && Choice{dot.method, dot.dt} == *now_) return dot;
  }
  return std::nullopt;
}

/// From the first touch of the exact solution follows how long a run shall be.
void ErrorChart::start_anew(const Simulation& simulation) {
  trouble_.clear();
  dots_.clear();
  others_.clear();
  begun_ = 0;
  own_.reset();
  run_.reset();
  start_ = simulation.clone();
  start_->keep_energy_book(false);
  try {
    duration_ = without_bounces;
    const std::unique_ptr<Simulation> first = start_->clone();
    const Method by_events = offers(methods::exact) ? methods::exact : methods::reference;
    if (offers(by_events)) first->use_method(by_events);
    first->restart();
    const double touch = first->next_event();
    if (std::isfinite(touch)) duration_ = std::clamp(bounces * touch, 1e-9, longest_run);
    if (first->error() && first->balls() <= most_balls) return choose_steps();
  } catch (const std::exception&) {  // the exact method refuses what depends on a player's hands
  }
  trouble_ = "There is no exact solution to compare with.";
}

bool ErrorChart::offers(Method method) const {
  if (!start_) return false;
  const std::vector<Method> all = start_->methods();
  return std::find(all.begin(), all.end(), method) != all.end();
}

/// Coarse steps of all methods first: they are quick, and the picture fills.
void ErrorChart::choose_steps() {
  const std::optional<ContactNumbers> contact = start_->contact();
  double dt = round_step(contact ? std::numbers::pi / contact->omega0 / 3 : duration_ / 20);
  for (int i = 0; i < steps_per_method && is_affordable(dt); ++i, dt = round_step(dt / 2.5)) {
    for (const Method method : start_->methods()) {
      if (!method.goes_by_events) others_.push_back({method, dt});
    }
  }
}

bool ErrorChart::is_affordable(double dt) const {
  const double balls = static_cast<double>(start_->balls());
  return duration_ / dt * balls * balls <= most_steps_of_a_run;
}

void ErrorChart::work(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (!is_done() && std::chrono::duration<double>(Clock::now() - begin).count() < seconds) {
    if (!run_) begin_next();
    next_sample(*run_);
    if (run_->sampled < samples) continue;
    finish(*run_);
    run_.reset();
  }
}

void ErrorChart::begin_next() {
  const bool own = wants_own();
  run_ = Run{own ? *now_ : others_[begun_++], own, start_->clone()};
  run_->simulation->use_method(run_->choice.method);
  run_->simulation->use_dt(run_->choice.dt);
  run_->simulation->restart();
}

/// Whether the simulation's own choice is still to be run: it is none of the others, and it can be.
bool ErrorChart::wants_own() const {
  if (!start_ || !trouble_.empty() || !now_ || own_ || now_->method.goes_by_events) return false;
  const bool is_other = std::find(others_.begin(), others_.end(), *now_) != others_.end();
  return !is_other && is_affordable(now_->dt);
}

/// To the end of the first step at or after the sample's time: no step is cut for it.
void ErrorChart::next_sample(Run& run) {
  Simulation& simulation = *run.simulation;
  const double until = duration_ * static_cast<double>(++run.sampled) / samples;
  const double left = (until - simulation.time()) / simulation.dt();
  if (left < 1e-6) return;  // a long step is already there
  try {
    simulation.advance_to(simulation.time_of_next_step() +
                          (std::ceil(left - 1e-6) - 1) * simulation.dt());
    const std::optional<StateError> error = simulation.error();
    run.error = std::max(run.error, error ? error->position : no_number);
  } catch (const std::exception&) {  // too large a step: the state became infinite
    run.error = no_number;
    run.sampled = samples;
  }
}

void ErrorChart::finish(const Run& run) {
  const long long calls = run.simulation->steps() * run.choice.method.evaluations +
                          run.simulation->counted_force_evaluations();
  const Dot dot{run.choice.method, run.choice.dt,
                static_cast<double>(calls) / run.simulation->time(), run.error};
  if (!run.own) {
    dots_.push_back(dot);
  } else if (run.choice == *now_) {
    own_ = dot;
  }
}

}  // namespace bounce
