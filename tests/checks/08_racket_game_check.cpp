#include "checks/08_racket_game_questions.hpp"

#include <doctest/doctest.h>

namespace bounce::check::racket_game {

TEST_SUITE("08_racket_game") {
  TEST_CASE("over the disc the nearest point is straight below the ball") {
    std::vector<Moment> places = moments(81, over, 0, false);
    for (std::size_t i = 0; i < places.size(); i += 8) {  // straight above the centre, exactly
      Moment& m = places[i];
      m.setting.centre = {};
      m.setting.disc_normal = up(1);
      m.motion.position = up(0.05 * m.setting.side);
    }
    judge(nearest_question("the nearest point of the racket", "m", point_of), places);
  }
  TEST_CASE("over the disc the push goes along the normal, to the ball's side") {
    judge(nearest_question("the direction of the push", "", direction_of),
          moments(82, over, 0, false));
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, moments(82, over, 0, false));
  }
  TEST_CASE("is the ball on the disc? Beside it the nearest point is on the rim") {
    judge(nearest_question("the nearest point of the racket", "m", point_of),
          moments(83, beside, 0, false));
  }
  TEST_CASE("beside the disc the push goes from the rim to the ball") {
    judge(nearest_question("the direction of the push", "", direction_of),
          moments(84, beside, 0, false));
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, moments(84, beside, 0, false));
  }
  TEST_CASE("a ball exactly on the rim, or exactly a radius out") {
    std::vector<Moment> edge = moments(85, over, 0, false);
    for (std::size_t i = 0; i < edge.size(); ++i) {  // numbers that add up without rounding
      Moment& m = edge[i];
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.disc_radius = 0.5;
      m.motion.position = {0.5, i % 2 == 0 ? 0 : -0.25, 0};
    }
    judge(nearest_question("the direction of the push", "", direction_of), edge);
    Question<Moment> q = nearest_question("the distance", "m", distance_of);
    q.names = {"", "distance", ""};
    judge(q, edge);
  }
  TEST_CASE("a racket at rest: gravity, and the law of stage 7 along the push") {
    judge(force_question("the force on the ball"), moments(86, anywhere, 0, false));
  }
  TEST_CASE("a racket that moves and turns: the damper sees the velocity between the two") {
    judge(force_question("the force on the ball"), moments(87, anywhere, 3, false));
  }
  TEST_CASE("both kinds of contact") {
    judge(force_question("the force on the ball"), moments(88, over, 3, true));
  }
  TEST_CASE("a ball that just touches has no overlap yet") {
    std::vector<Moment> edge = moments(89, over, 0, false);
    for (Moment& m : edge) {
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.radius = 0.25;
      m.setting.side = 1;
      m.motion.position = {0, 0.25, 0};
    }
    judge(force_question("the force on a ball at exactly distance r"), edge);
  }
  TEST_CASE("the side changes only while the two do not touch") {
    Question<Moment> q = question("the side that choose_side keeps or chooses", "");
    q.names = {"", "side", ""};
    q.answer = [](const Moment& m) {
      return up(subject().side_after(m.setting, m.t, m.motion.position));
    };
    q.truth = [](const Moment& m) {
      const Setting& s = m.setting;
      const Now now = racket_at(m);
      const Triple way = plus(m.motion.position, now.centre, -1);
      const double height = dot(now.normal, way);
      const bool is_over = length(plus(way, now.normal, -height)) < s.disc_radius;
      const bool touches = is_over && s.side * height < s.radius;
      return up(touches ? s.side : height < 0 ? -1 : 1);
    };
    q.rounding = [](const Moment&) { return 0; };
    q.look_at = "over the disc, and side * height < radius: keep it. Else the side of the height.";
    judge(q, moments(90, anywhere, 3, false));
    std::vector<Moment> far = moments(91, anywhere, 3, false);
    for (Moment& m : far) {
      m.motion.position = plus(m.motion.position, m.setting.disc_normal, -4 * m.setting.side);
    }
    judge(q, far);
    std::vector<Moment> edge = moments(92, over, 0, false);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      Moment& m = edge[i];
      m.setting.centre = {0, 0, 0};
      m.setting.disc_normal = {0, 1, 0};
      m.setting.disc_radius = 0.5;
      m.setting.radius = 0.25;
      static const Triple places[] = {
          {0.5, 0.125, 0}, {0.5, 0, 0}, {0, 0.25, 0}, {0, -0.25, 0}, {0, 0, 0}};
      m.motion.position = places[i % 5];
    }
    judge(q, edge);
  }
  TEST_CASE("the ball bounces once on a disc at rest, as the formula says, for several dt") {
    Dice dice(93);
    std::vector<Run> runs;
    for (const double dt : {1e-4, 5e-5, 1e-5}) {
      Setting s = any_setting(dice);
      s.damping = dice.between(0.02, 0.3) * 2 * std::sqrt(s.stiffness * s.mass);
      Triple n = dice.direction();
      n[1] = 1 + std::abs(n[1]);
      n = times(1 / length(n), n);
      s.disc_normal = n;
      s.disc_radius = 30;
      runs.push_back(bounce_run(s, n, dice.between(0.3, 1.5), dt));
    }
    judge_runs("docs/08_racket_game.md, \"The program\"", runs);
  }
}

}  // namespace bounce::check::racket_game
