#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "07_tilted_plane/exact.hpp"
#include "07_tilted_plane/tilted_plane.hpp"
#include "08_racket_game/racket_game.hpp"
#include "08_racket_game/run/command_line.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "rounding.hpp"
#include "run/save_load.hpp"
#include "run_program.hpp"
#include "run_with.hpp"
#include "stages/scene_simulations.hpp"

using namespace bounce;
using Eigen::Vector3d;
using test::epsilon;
using test::set_up;
using test::text;
using test::Values;
using Ball = State<Vector3d>;

namespace {

using Run7 = OneBallRun<TiltedPlane, TiltedPlaneExact>;

const std::vector<Method> stepping{methods::explicit_euler, methods::semi_implicit_euler,
                                   methods::velocity_verlet, methods::rk4};

/// Ball and racket in uniform motion.
BareRacketRun bare(const Values& settings, Method method, double dt = 1e-3) {
  return test::run_with<BareRacketRun>(settings, method, dt);
}

Ball ball_of(const BareRacketRun& run) { return run.state(); }
Ball ball_of(const GameRun& run) { return run.round().ball; }

/// The hard case: a racket that moves by five ball radii a step, and a contact shorter than a step.
const Values fast_racket{
    {"mass", "0.06"},      {"radius", "0.03"},  {"stiffness", "9000"},        {"damping", "2"},
    {"position", "0,1,0"}, {"gravity", "9.81"}, {"racket_velocity", "0,15,0"}};

}  // namespace

// ---- The force

TEST_CASE("stage 8: over the disc the force is stage 7's, but for roundings of the height") {
  for (const ContactLaw law : {ContactLaw::may_pull, ContactLaw::push_only}) {
    TiltedPlane plane;
    Racket racket;
    plane.normal = Vector3d(0.3, 1, -0.2).normalized();
    racket.disc.normal = plane.plane().normal;
    racket.disc.radius = 5;
    plane.contact = racket.contact = law;
    plane.damping = racket.damping;
    for (double height = -0.15; height < 0.15; height += 0.01) {
      for (const Vector3d& velocity : {Vector3d(1, -3, 0.5), Vector3d(0, 2, 0)}) {
        const Ball ball{Vector3d(0.4, 0, 0.3) + height * racket.disc.normal, velocity};
        // Both take the height as a dot product, of sums in a different order: some roundings of
        // lengths below 1 m, times the stiffness.
        const double tolerance = 20 * epsilon * racket.stiffness;
        CAPTURE(height);
        CHECK((racket.force(0, ball) - plane.force(0, ball)).norm() <= tolerance);
      }
    }
  }
}

TEST_CASE("stage 8: a ball from below is pushed down") {
  Racket racket;
  const Ball below{{0.1, -0.09, 0}, {0, 1, 0}};
  racket.start_side(0, below.position);
  CHECK(racket.side == -1);
  CHECK(racket.force(0, below).y() < -racket.mass * racket.gravity);
  // Deep in, with its centre above the disc already, it is still pushed down.
  const Ball deep{{0.1, 0.02, 0}, {0, 1, 0}};
  racket.choose_side(0, deep.position);
  CHECK(racket.side == -1);
  CHECK(racket.force(0, deep).y() < -1000);
}

TEST_CASE("stage 8: at the rim the push goes from the nearest rim point to the ball") {
  Racket racket;
  racket.damping = 0;
  racket.gravity = 0;
  for (const double angle : {0.0, 0.7, 2.0, 4.0}) {     // around the disc
    for (const double rise : {-1.2, -0.3, 0.0, 0.8}) {  // of the push
      const Vector3d outwards(std::cos(angle), 0, std::sin(angle));
      const Vector3d direction = std::cos(rise) * outwards + std::sin(rise) * Vector3d::UnitY();
      const double distance = 0.08;
      const Ball ball{racket.disc.radius * outwards + distance * direction, {0, 0, 0}};
      const Vector3d expected =
          racket.stiffness * (racket.radius - distance) * direction;  // whatever the side
      CAPTURE(angle);
      CAPTURE(rise);
      CHECK((racket.force(0, ball) - expected).norm() <= 20 * epsilon * racket.stiffness);
    }
  }
}

TEST_CASE("stage 8: the hand-over at the lateral distance R is continuous") {
  // In position: the force differs by no more than stiffness x shift, so by 2e-9 N here.
  const double shift = 1e-13;
  Racket racket;
  racket.disc.normal = Vector3d(0.1, 1, 0.2).normalized();
  racket.disc.angular_velocity = {0.5, 0, 1};
  racket.disc.velocity = {0.1, 2, 0};
  const Vector3d along = racket.disc.normal.cross(Vector3d::UnitZ()).normalized();
  for (const int side : {1, -1}) {
    for (const double height : {0.001, 0.02, 0.06, 0.09}) {
      racket.side = side;
      const auto force_at = [&](double lateral) {
        const Vector3d place = lateral * along + side * height * racket.disc.normal;
        return racket.force(0, {place, {0.3, -1, 0.2}});
      };
      const Vector3d inside = force_at(racket.disc.radius - shift);
      const Vector3d outside = force_at(racket.disc.radius + shift);
      CAPTURE(side);
      CAPTURE(height);
      CHECK(inside.norm() > 50);  // they touch
      // Near the disc the direction turns by shift / height: another k r shift / height.
      const double tolerance =
          4 * (racket.stiffness + racket.stiffness * racket.radius / height) * (shift + epsilon);
      CHECK((inside - outside).norm() <= tolerance);
    }
  }
}

TEST_CASE("stage 8: the damper sees the velocity of the point that is touched") {
  Racket racket;
  racket.disc.velocity = {0, 1, 0};
  racket.disc.angular_velocity = {0, 0, 2};  // at x = 0.25 the disc moves up by another 0.5 m/s
  const Vector3d place(0.25, 0.09, 0);
  const Vector3d with_racket(0, 1.5, 0);
  const double spring = racket.stiffness * (racket.radius - 0.09);
  const auto push = [&](const Vector3d& velocity) {
    return racket.force(0, {place, velocity}).y() + racket.mass * racket.gravity;
  };
  CHECK(push(with_racket) == doctest::Approx(spring).epsilon(1e-12));
  CHECK(push({0, 0, 0}) == doctest::Approx(spring + 1.5 * racket.damping).epsilon(1e-12));
}

// ---- Movement

TEST_CASE("stage 8: exact over the disc is stage 7's exact, seen from the moving racket") {
  const Vector3d normal(0.05, 1, 0.02), u(0.2, 1.5, -0.1);
  for (const char* law : {"may-pull", "push-only"}) {
    const Values common{{"contact", law}, {"damping", "10"}};
    Values disc = common, plane = common;
    disc.insert(disc.end(), {{"racket_normal", text(3 * normal)},  // of any length
                             {"racket_radius", "50"},
                             {"racket_velocity", text(u)},
                             {"velocity", text(u + Vector3d(0.1, 0, 0))},
                             {"position", "0,1,0"}});
    plane.insert(plane.end(),
                 {{"normal", text(normal)}, {"velocity", "0.1,0,0"}, {"position", "0,1,0"}});
    BareRacketRun run = bare(disc, methods::exact);
    Run7 other;
    set_up(other, plane, methods::exact, 1e-3);
    for (double t = 0.1; t < 5; t += 0.1) {
      run.advance_to(t);
      other.advance_to(t);
      CAPTURE(law);
      CAPTURE(t);
      // Rounding of positions up to 10 m, at some ten events that each double an error of the time.
      REQUIRE((ball_of(run).position - u * t - other.state().position).norm() < 1e-11);
      REQUIRE((ball_of(run).velocity - u - other.state().velocity).norm() < 1e-10);
    }
  }
}

TEST_CASE("stage 8: a fast racket hits once, as exact says") {
  BareRacketRun exact = bare(fast_racket, methods::exact);
  exact.advance_to(0.3);
  const Ball expected = ball_of(exact);
  CHECK(expected.velocity.y() > 25);
  for (const Method method : stepping) {
    // Whatever part of a step lies before the touch.
    for (const double dt : {0.01, 0.0097, 0.011, 0.05, 1e-3}) {
      BareRacketRun run = bare(fast_racket, method, dt);
      run.advance_to(0.3);
      const std::string name = name_of(method);
      CAPTURE(name);
      CAPTURE(dt);
      // 1e-3 of the way and of the speed. The method has the contact only, in pieces with
      // omega0 h = 0.001: explicit Euler gains pi/2 of that, the others stay far below.
      CHECK((ball_of(run).position - expected.position).norm() < 1e-3 * 7);
      CHECK((ball_of(run).velocity - expected.velocity).norm() < 1e-3 * 28);
      if (method == methods::explicit_euler) continue;
      CHECK((ball_of(run).position - expected.position).norm() < 1e-3);
      CHECK((ball_of(run).velocity - expected.velocity).norm() < 1e-3);
    }
  }
}

TEST_CASE("stage 8: a fast racket touches exactly once") {
  for (const double speed : {15.0, -15.0, 100.0}) {           // from below, from above, and faster
    for (double start = 0.5; start < 0.66; start += 0.013) {  // any phase of the step
      Racket scene;
      scene.mass = 0.06, scene.radius = 0.03, scene.stiffness = 9000, scene.damping = 2;
      scene.gravity = 0;
      scene.disc.velocity = {0, speed, 0};
      Ball ball{{0.01, speed > 0 ? start : -start, 0}, {0, 0, 0}};
      scene.start_side(0, ball.position);
      ContactSteps<SemiImplicitEuler> steps(scene);
      for (int i = 0; i < 30; ++i) steps(i * 0.01, ball, 0.01);
      const double after = ball.velocity.y() / speed;  // 1 + e
      CAPTURE(speed);
      CAPTURE(start);
      CHECK(steps.touches == 1);
      const double e = restitution({9000, 2, ContactLaw::may_pull}, 0.06);
      CHECK(after == doctest::Approx(1 + e).epsilon(1e-3));
    }
  }
}

TEST_CASE("stage 8: a racket that tilts fast does not pass through the ball") {
  // The edge at 0.25 m comes up with 25 m/s and is through the ball within one step of 10 ms.
  Racket scene;
  scene.gravity = 0;
  scene.stiffness = 1e6;  // a contact of 3 ms
  scene.disc.angular_velocity = {0, 0, 100};
  Ball ball{{0.25, 0.13, 0}, {0, 0, 0}};
  ContactSteps<Rk4> steps(scene);
  steps(0, ball, 0.01);
  CHECK(steps.touches >= 1);
  CHECK(ball.velocity.y() > 20);
}

TEST_CASE("stage 8: whoever moves with constant velocity sees the shifted movement") {
  const Vector3d u(3, -2, 1);
  for (const Method method : {methods::explicit_euler, methods::semi_implicit_euler,
                              methods::velocity_verlet, methods::rk4, methods::exact}) {
    const Values still{
        {"position", "0.02,0.6,0.1"}, {"racket_normal", "0.01,1,0"}, {"racket_radius", "2"}};
    Values moving = still;
    moving.push_back({"velocity", text(u)});
    moving.push_back({"racket_velocity", text(u)});
    BareRacketRun run = bare(still, method), other = bare(moving, method);
    for (double t = 0.25; t <= 2; t += 0.25) {
      run.advance_to(t);
      other.advance_to(t);
      const std::string name = name_of(method);
      CAPTURE(name);
      CAPTURE(t);
      // Relative to where the shifted ball is: there a double has 1e-15 m, rounded 2000 times.
      const double scale = 1 + (u * t).norm();
      REQUIRE((ball_of(other).position - u * t - ball_of(run).position).norm() <= 1e-12 * scale);
      REQUIRE((ball_of(other).velocity - u - ball_of(run).velocity).norm() <= 1e-12 * scale);
    }
  }
}

TEST_CASE("stage 8: the rim throws the ball outwards, and the disc is as large as it counts") {
  const auto after = [](double x) {
    BareRacketRun run =
        bare({{"position", text(Vector3d(x, 0.5, 0))}, {"damping", "0"}}, methods::rk4);
    run.advance_to(0.5);
    return ball_of(run);
  };
  CHECK(after(0.299).velocity.x() == 0);   // over the disc: straight up
  CHECK(after(0.301).velocity.x() > 0);    // over the rim: a little outwards
  CHECK(after(0.34).velocity.x() > 1);     // the more, the further out
  CHECK(after(0.4001).velocity.x() == 0);  // past it
  CHECK(after(0.4001).velocity.y() == doctest::Approx(-9.81 * 0.5).epsilon(1e-12));
}

TEST_CASE("stage 8: exact knows which ball meets the rim") {
  const std::string program = "08_racket_game --player none --headless --method exact ";
  const test::Outcome rim = test::run_program(program + "--set position=0.35,1,0");
  CHECK(rim.code == 3);
  CHECK(rim.err.find("rim") != std::string::npos);
  CHECK(rim.err.find("t = 0.4315") != std::string::npos);  // sqrt(2 (0.9 + 0.1 - 0.0866) / 9.81)
  // Past the rim, up beside the disc and down on it, out over the edge: only the last ends at it.
  CHECK(test::run_program(program + "--set position=0.41,1,0").code == 0);
  const test::Outcome up = test::run_program(
      program + "--set position=0.6,-0.5,0 --set velocity=-0.5,5,0 --duration 1.5");
  CHECK(up.code == 0);
  CHECK(test::run_program(program + "--set velocity=0.2,0,0").code == 3);
}

TEST_CASE("stage 8: a ball that comes up beside the disc lands on it") {
  const Values words{{"position", "0.6,-0.5,0"}, {"velocity", "-0.5,5,0"}};
  BareRacketRun exact = bare(words, methods::exact), stepped = bare(words, methods::rk4);
  exact.advance_to(1.5);
  stepped.advance_to(1.5);
  CHECK(ball_of(exact).position.y() > 0.1);
  CHECK((ball_of(stepped).position - ball_of(exact).position).norm() < 1e-3);
}

// ---- The game

namespace {

GameRun game(PlayerKind player, std::uint64_t seed, const Values& settings = {}) {
  GameRun run;
  run.play_as(player);
  run.use_seed(seed);
  set_up(run, settings);
  return run;
}

/// Tops of the ball's flights in `seconds`, as heights of its centre [m].
std::vector<double> tops(GameRun& run, double seconds) {
  std::vector<double> heights;
  double before = 0;
  while (run.time() < seconds) {
    run.advance_one_step();
    const double up = ball_of(run).velocity.y();
    if (before > 0 && up <= 0 && ball_of(run).position.y() > 0.3) {
      heights.push_back(ball_of(run).position.y());
    }
    before = up;
  }
  return heights;
}

}  // namespace

TEST_CASE("stage 8: score") {
  Score score;
  CHECK_FALSE(score.watch(false, 0.5, 1));  // it has not touched yet
  CHECK_FALSE(score.watch(true, -0.01, 1));
  CHECK_FALSE(score.watch(false, 0.05, 1));  // it has not risen yet
  CHECK_FALSE(score.watch(true, 0, 1));      // a second touch of the same hit
  CHECK(score.watch(false, 0.11, 1));
  CHECK_FALSE(score.watch(false, 0.2, 1));  // counted already
  CHECK(score.hits == 1);
  CHECK(score.best == 1);
  CHECK_FALSE(score.watch(false, -0.5, -0.01));
  CHECK(score.lost);
  CHECK_FALSE(score.watch(true, 0.2, 1));  // the round is over
  CHECK(score.hits == 1);
}

TEST_CASE("stage 8: difficulty grows with every hit, up to an end") {
  CHECK(disc_radius_after(0, 0.3) == 0.3);
  CHECK(disc_radius_after(1, 0.3) == doctest::Approx(0.294));
  CHECK(disc_radius_after(34, 0.3) > 0.15);
  CHECK(disc_radius_after(35, 0.3) == 0.15);  // 0.98^35 = 0.493
  CHECK(gravity_after(0, 9.81) == 4);
  CHECK(gravity_after(3, 9.81) == 4.75);
  CHECK(gravity_after(23, 9.81) == 9.75);
  CHECK(gravity_after(24, 9.81) == 9.81);
}

TEST_CASE("stage 8: the racket follows within its limits and does not overshoot") {
  for (const double distance : {0.01, 0.1, 1.0, -0.7}) {
    for (const double dt : {1e-3, 2.5e-4, 5e-3}) {
      Follower racket;
      double near_at = never;
      for (double t = 0; t < 2; t += dt) {
        const double before = racket.velocity;
        follow(racket, distance, sideways, dt);
        CHECK(std::abs(racket.velocity) <= sideways.speed * (1 + 1e-12));
        CHECK(std::abs(racket.velocity - before) <= sideways.acceleration * dt * (1 + 1e-9));
        CHECK(racket.position / distance < 1.02);
        if (racket.position / distance > 0.95) near_at = std::min(near_at, t);
      }
      CAPTURE(distance);
      CAPTURE(dt);
      CHECK(racket.position == doctest::Approx(distance).epsilon(1e-6));
      // 79 ms for a small move (4.74 / rate), and the step at 6 m/s and 150 m/s^2 for a large one.
      CHECK(near_at < 0.079 + std::abs(distance) / sideways.speed + 0.06 + dt);
    }
  }
}

// Four test cases, so that each is short in a build with sanitizers too.
static void autopilot_keeps_it_up(std::uint64_t first_seed) {
  for (std::uint64_t seed = first_seed; seed < first_seed + 5; ++seed) {
    GameRun run = game(PlayerKind::autopilot, seed);
    while (run.round().score.hits < 200 && !run.round().score.lost && run.time() < 400) {
      run.advance_to(run.time() + 1);
    }
    CAPTURE(seed);
    CHECK(run.round().score.hits >= 200);
    CHECK_FALSE(run.round().score.lost);
  }
}
TEST_CASE("stage 8: the autopilot makes 200 hits, seeds 1 to 5") { autopilot_keeps_it_up(1); }
TEST_CASE("stage 8: the autopilot makes 200 hits, seeds 6 to 10") { autopilot_keeps_it_up(6); }
TEST_CASE("stage 8: the autopilot makes 200 hits, seeds 11 to 15") { autopilot_keeps_it_up(11); }
TEST_CASE("stage 8: the autopilot makes 200 hits, seeds 16 to 20") { autopilot_keeps_it_up(16); }

TEST_CASE("stage 8: who does nothing loses") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GameRun run = game(PlayerKind::idle, seed);
    run.advance_to(10);
    CAPTURE(seed);
    CHECK(run.round().score.lost);
    CHECK(run.round().score.hits < 10);
  }
}

TEST_CASE("stage 8: the assist takes all of the aim off the player, but not the swing") {
  GameRun run = game(PlayerKind::human, 7, {{"assist", "100"}});
  while (run.time() < 60 && !run.round().score.lost) {
    Input input;  // a player who never moves, and swings when the ball comes down
    const Ball ball = ball_of(run);
    const double up = ball.velocity.y(), height = ball.position.y() - 0.16;
    input.swing = up < 0 && height < -up * 0.15 ? 1 : 0;
    run.want(input);
    run.advance_to(run.time() + 1.0 / 60);
  }
  CHECK_FALSE(run.round().score.lost);
  CHECK(run.round().score.hits > 30);
}

TEST_CASE("stage 8: blind, struck while the racket slows down, the ball comes back by itself") {
  // After Schaal, Sternad and Atkeson (1996): stable while the racket's acceleration at the hit is
  // between -2 g (1 + e^2) / (1 + e)^2 = -9.93 m/s^2 and 0. Here it is -4.89.
  GameRun steady = game(PlayerKind::blind, 1, {{"knock", "0"}});
  const std::vector<double> rest = tops(steady, 100);
  REQUIRE(rest.size() > 100);
  const double height = rest.back();
  for (const char* knock : {"0.2", "-0.2"}) {
    GameRun run = game(PlayerKind::blind, 1, {{"knock", knock}});
    const std::vector<double> after = tops(run, 30);
    REQUIRE(after.size() > 25);
    CAPTURE(knock);
    CHECK(std::abs(game(PlayerKind::blind, 1, {{"knock", knock}}).round().ball.position.y() -
                   height) > 0.15);
    for (std::size_t i = 9; i < after.size(); ++i) {
      CAPTURE(i);
      CHECK(std::abs(after[i] - height) < 0.03);
    }
  }
}

TEST_CASE("stage 8: blind, struck while the racket speeds up, the ball leaves its beat") {
  const auto heights_after = [](const char* knock, const char* strike) {
    GameRun run = game(PlayerKind::blind, 1, {{"knock", knock}, {"strike", strike}});
    return tops(run, 30);
  };
  const double start = game(PlayerKind::blind, 1, {{"knock", "0"}, {"strike", "speeding"}})
                           .round()
                           .ball.position.y();
  // The beat is there, but it is unstable: the small difference of the first top only grows.
  const std::vector<double> alone = heights_after("0", "speeding");
  REQUIRE(alone.size() > 20);
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(std::abs(alone[i] - start) < 0.1);
    CHECK(std::abs(alone[i + 1] - start) > 1.4 * std::abs(alone[i] - start));
  }
  // Those that fly on end in the other beat, which meets a racket that slows down.
  const double stable = heights_after("0", "slowing").back();
  CHECK(std::abs(stable - start) > 0.1);
  for (const char* knock : {"0", "0.05", "0.2"}) {
    const std::vector<double> heights = heights_after(knock, "speeding");
    CAPTURE(knock);
    REQUIRE(heights.size() > 25);
    CHECK(std::abs(heights.back() - stable) < 0.01);
  }
  // One that starts too low comes too early, and is soon carried up and down.
  CHECK(heights_after("-0.2", "speeding").size() < 4);
}

TEST_CASE("stage 8: a recorded round comes again to the bit") {
  namespace fs = std::filesystem;
  const std::string path = (fs::temp_directory_path() / "bounce_stage_8_input").string();
  const auto log = std::make_shared<InputLog>();
  GameRun run = game(PlayerKind::human, 11, {{"assist", "60"}, {"racket_radius", "0.35"}});
  run.record(log);
  run.restart();
  // Frames of different lengths, and a hand that moves.
  for (int frame = 0; run.time() < 8; ++frame) {
    const double t = run.time();
    run.want({0.2 * std::sin(3 * t), 0.1 * std::cos(5 * t), 0.3 * std::sin(t), 0,
              std::fmod(t, 0.7) < 0.3 ? 1.0 : 0.0, 0});
    run.advance_to(t + (frame % 7 == 0 ? 0.05 : 0.016));
  }
  write_input_log(path, *log);

  GameRun again;
  again.replay(std::make_shared<const InputLog>(read_input_log(path)));
  again.restart();
  again.advance_to(run.time());
  CHECK(ball_of(again).position == ball_of(run).position);
  CHECK(ball_of(again).velocity == ball_of(run).velocity);
  CHECK(again.round().score.hits == run.round().score.hits);
  CHECK(run.round().touches > 2);
  fs::remove(path);
}

TEST_CASE("stage 8: a saved game goes on as if it had not stopped") {
  const std::string path =
      (std::filesystem::temp_directory_path() / "bounce_stage_8_saved").string();
  const StageName stage{"08_racket_game", ""};
  GameRun whole = game(PlayerKind::autopilot, 3);
  whole.advance_to(4.321);
  save_state(path, stage, whole);
  whole.advance_to(9);
  // The file says who plays, and with which seed.
  GameRun resumed = test::loaded<GameRun>(path, stage);
  resumed.advance_to(9);
  CHECK(ball_of(resumed).position == ball_of(whole).position);
  CHECK(resumed.round().score.hits == whole.round().score.hits);

  for (const Method method : {methods::semi_implicit_euler, methods::reference, methods::exact}) {
    BareRacketRun ball = bare({{"racket_velocity", "0,0.5,0"}}, method);
    ball.advance_to(0.4271);
    save_state(path, stage, ball);
    ball.advance_to(2);
    BareRacketRun other = test::loaded<BareRacketRun>(path, stage);
    other.advance_to(2);
    const std::string name = name_of(method);
    CAPTURE(name);
    CHECK(ball_of(other).position == ball_of(ball).position);
  }
  std::filesystem::remove(path);
}

TEST_CASE("stage 8: the command line") {
  const test::Outcome rows = test::run_program(
      "08_racket_game --player none --headless --csv - --at 0 --set position=0,2,0 --set "
      "racket_normal=0,-5,0");
  CHECK(rows.code == 0);
  CHECK(rows.out == "t,x,y,z,vx,vy,vz\n0,0,2,0,0,0,0\n");

  const test::Outcome autopilot =
      test::run_program("08_racket_game --player autopilot --headless --duration 30 --seed 4");
  CHECK(autopilot.code == 0);
  CHECK(autopilot.err.find("lost=no") != std::string::npos);
  CHECK(test::run_program("08_racket_game --player idle --headless").err.find("lost=yes") !=
        std::string::npos);

  for (const char* option : {"--record-input", "--replay"}) {  // a round is known from its start on
    const test::Outcome outcome =
        test::run_program("08_racket_game --headless --load s " + std::string(option) + " r");
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(std::string("leave out ") + option) != std::string::npos);
  }

  for (const char* bad :
       {"--player autopil", "--player ''", "--set racket_normal=0,0,0", "--set racket_radius=0",
        "--set racket_radius=-1", "--set racket_velocity=0,nan,0", "--set racket_position=1,2",
        "--set assist=101", "--set strike=up", "--replay /nowhere/file",
        "--record-input /nowhere/file", "--method exact", "--method reference",
        "--player none --method rk5"}) {
    const test::Outcome outcome =
        test::run_program(std::string("08_racket_game --headless ") + bad);
    CAPTURE(bad);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("08_racket_game: ") == 0);
  }
}
