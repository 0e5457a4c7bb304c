// How BallsWorld comes to its balls: scenes, files, parameters.

#include "05_ball_collision/run/balls_world.hpp"

namespace bounce {

void BallsWorld::choose_scene(BallScene chosen) {
  own_balls = nullptr;
  BallCollision fresh;
  fresh.mass = scene.mass;  // until the next start
  fresh.radius = scene.radius;
  scene = fresh;
  constexpr std::array<double, 5> counts{2, 16, 5, 2, 300};
  choice = {chosen, counts[static_cast<std::size_t>(chosen)], 0};
  switch (chosen) {
    case BallScene::pair:
    case BallScene::break_up:
    case BallScene::cradle:
      scene.gravity = 0;  // a table without friction, on which gravity has nothing to say
      break;
    case BallScene::tower:  // hard balls, so that the one is done before the other begins
      scene.stiffness = scene.floor_stiffness = 1e5;
      break;
    case BallScene::drop:
      choice.gap = 0.0143;  // the lattice fills 35 % of the space
      scene.stiffness = scene.floor_stiffness = 2e4;
      scene.damping = scene.floor_damping = 20;
      scene.tray = {tray_for(choice.count), tray_for(choice.count)};
      break;
  }
  tray_of_scene_ = scene.tray;
}

void BallsWorld::use_balls(Arrangement balls, const std::string& from) {
  choose_scene(BallScene::pair);
  scene.gravity = BallCollision{}.gravity;
  own_balls = std::make_shared<const Arrangement>(std::move(balls));
  origin = "--balls " + from;
}

void BallsWorld::take_over(Arrangement balls, const std::string& from) {
  scene.mass = balls.mass;
  scene.radius = balls.radius;
  own_balls = std::make_shared<const Arrangement>(std::move(balls));
  origin = from;
}

BallsWorld::Balls BallsWorld::start(std::uint64_t chosen_seed) {
  seed = chosen_seed;
  if (choice.scene == BallScene::drop && scene.tray == tray_of_scene_) {
    scene.tray = {tray_for(choice.count), tray_for(choice.count)};
    tray_of_scene_ = scene.tray;
  }
  const Arrangement start = own_balls ? *own_balls : arrange(choice, scene.tray, seed);
  scene.mass = start.mass;
  scene.radius = start.radius;
  return start.balls;
}

std::vector<Parameter> BallsWorld::parameters() {
  Choice scenes{{"pair", "break", "cradle", "tower", "drop"},
                [this] { return static_cast<std::size_t>(choice.scene); },
                [this](std::size_t index) { choose_scene(static_cast<BallScene>(index)); }};
  Parameter which{"scene", "", "the balls at the start; it brings its own defaults of all others",
                  std::move(scenes)};
  which.is_start = which.chooses_defaults = true;
  // What is worth playing with depends on the scene: [lowest, highest] of its sliders.
  constexpr std::array<Range, 5> counts{{{2, 3}, {2, 56}, {2, 9}, {2, 3}, {2, 1000}}};
  constexpr std::array<Range, 5> gaps{{{0, 0.25}, {0, 0.05}, {0, 0.01}, {0, 0.2}, {0, 0.1}}};
  const auto chosen = static_cast<std::size_t>(choice.scene);
  Parameter count{"count",        "",  "balls of break, cradle and drop", &choice.count, {1, 1e7},
                  counts[chosen], true};
  count.is_whole = true;
  Parameter gap{
      "gap",       "m",      "between the balls at the start; in pair: how far off centre",
      &choice.gap, {0, 1e6}, gaps[chosen],
      true};
  std::vector<Parameter> all{which, count, gap};
  for (const Parameter& of_scene : scene.parameters()) all.push_back(of_scene);
  return all;
}

}  // namespace bounce
