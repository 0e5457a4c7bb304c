// How BallsSimulation comes to its balls: scenes, files, parameters.

#include "05_ball_collision/run/balls_simulation.hpp"

namespace bounce {

BallsSimulation::BallsSimulation() {
  choose_scene(BallScene::pair);
  reset_state();
}

/// A scene brings the parameters that suit it; whoever wants others sets them after it.
void BallsSimulation::choose_scene(BallScene scene) {
  own_balls_ = nullptr;
  scene_ = BallCollision{};
  choice_ = {scene, 2, 0};
  switch (scene) {
    case BallScene::pair:
      scene_.gravity = 0;  // a table without friction, on which gravity has nothing to say
      break;
    case BallScene::break_up:
      scene_.gravity = 0;
      choice_.count = 16;
      break;
    case BallScene::cradle:
      scene_.gravity = 0;
      choice_.count = 5;
      break;
    case BallScene::tower:  // hard balls, so that the one is done before the other begins
      scene_.stiffness = scene_.floor_stiffness = 1e5;
      break;
    case BallScene::drop:
      choice_.count = 300;
      choice_.gap = 0.0143;  // the lattice fills 35 % of the space
      scene_.stiffness = scene_.floor_stiffness = 2e4;
      scene_.damping = scene_.floor_damping = 20;
      scene_.tray = {tray_for(choice_.count), tray_for(choice_.count)};
      break;
  }
  tray_of_scene_ = scene_.tray;
}

void BallsSimulation::use_balls(Arrangement balls, const std::string& origin) {
  choose_scene(BallScene::pair);
  scene_.gravity = BallCollision{}.gravity;
  own_balls_ = std::make_shared<const Arrangement>(std::move(balls));
  origin_ = "--balls " + origin;
}

void BallsSimulation::continue_from(const many::LammpsFrame& frame, const std::string& origin) {
  const Eigen::Index count = frame.balls.position.cols();
  const bool complete = frame.mass.size() == count && frame.radius.size() == count;
  if (!complete && count != scene_.mass.size()) {
    throw BadInput(origin + " is not allowed: it has " + std::to_string(count) +
                   " balls without mass and radius, and the scene has " +
                   std::to_string(scene_.mass.size()) +
                   ": set count, or dump the columns mass and radius as well");
  }
  Arrangement balls(count);
  balls.mass = frame.mass.size() == count ? frame.mass : scene_.mass;
  balls.radius = frame.radius.size() == count ? frame.radius : scene_.radius;
  balls.balls = frame.balls;
  scene_.mass = balls.mass;
  scene_.radius = balls.radius;
  state_ = balls.balls;
  own_balls_ = std::make_shared<const Arrangement>(std::move(balls));
  origin_ = origin;
  parameters_changed();
  // The acceleration at the end of the last step is part of velocity Verlet's state: with damping
  // it is not what the new velocity would give.
  if (method() == Method::velocity_verlet && frame.force.cols() == count) {
    verlet_.acceleration = frame.force;
    for (Eigen::Index i = 0; i < count; ++i) verlet_.acceleration->col(i) /= scene_.mass[i];
  }
  Memory clock = memory();
  clock.time = static_cast<double>(frame.step) * dt();
  clock.grid_start = clock.into_step = 0;
  clock.grid_steps = clock.steps = frame.step;
  recall(clock);
}

void BallsSimulation::reset_state() {
  if (choice_.scene == BallScene::drop && scene_.tray == tray_of_scene_) {
    scene_.tray = {tray_for(choice_.count), tray_for(choice_.count)};
    tray_of_scene_ = scene_.tray;
  }
  const Arrangement start = own_balls_ ? *own_balls_ : arrange(choice_, scene_.tray, seed_);
  scene_.mass = start.mass;
  scene_.radius = start.radius;
  state_ = start.balls;
  parameters_changed();
}

std::vector<Parameter> BallsSimulation::parameters() {
  Choice scenes{{"pair", "break", "cradle", "tower", "drop"},
                [this] { return static_cast<std::size_t>(choice_.scene); },
                [this](std::size_t index) { choose_scene(static_cast<BallScene>(index)); }};
  Parameter scene{"scene", "", "the balls at the start; it brings its own defaults of all others",
                  std::move(scenes)};
  scene.is_start = scene.chooses_defaults = true;
  // What is worth playing with depends on the scene: [lowest, highest] of its sliders.
  constexpr std::array<Range, 5> counts{{{2, 3}, {2, 56}, {2, 9}, {2, 3}, {2, 1000}}};
  constexpr std::array<Range, 5> gaps{{{0, 0.25}, {0, 0.05}, {0, 0.01}, {0, 0.2}, {0, 0.1}}};
  const auto chosen = static_cast<std::size_t>(choice_.scene);
  Parameter count{"count",        "",  "balls of break, cradle and drop", &choice_.count, {1, 1e7},
                  counts[chosen], true};
  count.is_whole = true;
  Parameter gap{
      "gap",        "m",      "between the balls at the start; in pair: how far off centre",
      &choice_.gap, {0, 1e6}, gaps[chosen],
      true};
  Parameter floor_stiffness{"floor_stiffness",       "N/m",         "the same for floor and walls",
                            &scene_.floor_stiffness, {1e-30, 1e30}, {500, 1e5}};
  Parameter floor_damping{"floor_damping",       "N s/m",   "the same for floor and walls",
                          &scene_.floor_damping, {0, 1e30}, {0, 300}};
  Parameter tray{
      "tray",    "m",   "walls at x = 0 and LX, z = 0 and LZ; 0 for none", Components(scene_.tray),
      {0, 1e15}, {0, 5}};
  return {scene,
          count,
          gap,
          describe::gravity(scene_.gravity),
          describe::stiffness(scene_.stiffness),
          describe::damping(scene_.damping),
          describe::contact(scene_.contact),
          describe::floor(scene_.floor),
          floor_stiffness,
          floor_damping,
          tray};
}

std::string BallsSimulation::stage_options() const {
  std::string words;
  if (own_balls_) words += " " + origin_;
  if (threads_ != 1) words += " --threads " + std::to_string(threads_);
  if (seed_ != 1) words += " --seed " + std::to_string(seed_);
  return words;
}

}  // namespace bounce
