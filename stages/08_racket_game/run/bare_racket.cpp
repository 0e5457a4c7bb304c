#include "08_racket_game/run/bare_racket.hpp"

#include <algorithm>

namespace bounce {

template class RunOf<BareRacketWorld>;

Racket BareRacketWorld::scene_now() const {
  Racket scene = setup.racket;
  scene.disc.normal = Plane::from_equation(setup.racket_normal, 0).normal;
  scene.disc.velocity = setup.racket_velocity;
  scene.side = side;
  scene.through = through;
  return scene;
}

Racket BareRacketWorld::scene_at_rest() const {
  Racket scene = scene_now();
  scene.disc.centre.setZero();
  scene.disc.velocity.setZero();
  return scene;
}

Traits BareRacketWorld::traits(const Simulation& simulation) const {
  Traits all{"x,y,z,vx,vy,vz", setup.contact_numbers()};
  all.cuts_steps = true;
  all.pieces_per_step = std::max(1.0, simulation.dt() / longest_contact_piece(setup.racket));
  all.summary = "player=none";
  all.command = " --player none";
  all.saved_options = {{"player", "none"}};
  return all;
}

void BareRacketWorld::place(double t, const Ball& ball) {
  Racket scene = scene_now();
  scene.disc = disc(t);
  scene.since = t;
  // Put through the disc by hand, it is on the other side.
  const double depth = scene.radius - scene.side * scene.disc.height(ball.position);
  if (t == 0 || depth > 2 * scene.radius) scene.start_side(t, ball.position);
  scene.choose_side(t, ball.position);
  take_side_of(scene);
  seen_from_racket = seen_from(disc(t), ball);
}

Truth<RacketTruth, Eigen::Vector3d> BareRacketWorld::truth(double t, const Ball& ball) {
  constexpr double tightest = 1e-14;
  book_start_ = t;
  ball_at_book_start_ = ball;
  const Ball& seen = seen_from_racket;
  const RacketTruth::AtRim at_rim(contacts(t, seen), t, seen, tightest);
  return {RacketTruth(scene_now(), {phases(), t, seen}, at_rim), 5000000};
}

double BareRacketWorld::go_towards(ExactBesideRacket& method, double t, long long most_events,
                                   Ball& ball) {
  const double reached = method.go_towards(t, most_events, seen_from_racket);
  ball = from_ground(disc(reached), seen_from_racket);
  seen_from_racket = seen_from(disc(reached), ball);
  // In contact the side is that of the touch.
  Racket scene = scene_at_rest();
  const bool flies = method.walk.phase() == Phase::flight;
  scene.start_side(0, (flies ? seen_from_racket : method.walk.state_at_last_event()).position);
  take_side_of(scene);
  return reached;
}

double BareRacketWorld::go_towards(ReferenceBesideRacket& method, double t, long long most_events,
                                   Ball& ball) {
  const double reached = method.go_towards(t, most_events, seen_from_racket);
  ball = from_ground(disc(reached), seen_from_racket);
  side = method.walk.contacts().side();
  through = method.walk.contacts().place() == RacketContacts::Place::beyond;
  return reached;
}

/// The energy at the start, and what the racket has given since. Its velocity u is constant, so
/// that the work of its force F on the ball is the integral of F.u, and F = m (v' - g):
///   work = m u.(v - v0 - g t)
double BareRacketWorld::energy_before(const EnergyBook& book, bool /*by_events*/, double t,
                                      const Ball& ball) const {
  const Eigen::Vector3d gravity(0, -setup.racket.gravity, 0);
  const Eigen::Vector3d pushed =
      ball.velocity - ball_at_book_start_.velocity - gravity * (t - book_start_);
  return book.before + setup.racket.mass * dot(setup.racket_velocity, pushed);
}

}  // namespace bounce
