#pragma once
#include <vector>

#include "08_racket_game/exact/exact.hpp"
#include "08_racket_game/reference/racket_contacts.hpp"
#include "08_racket_game/run/contact_steps.hpp"
#include "08_racket_game/run/racket_setup.hpp"
#include "physics/remembered.hpp"
#include "run/run.hpp"

namespace bounce {

/// `exact` and `reference` for a ball and a racket in uniform motion: both walk in the racket's
/// frame of reference, where the racket rests.
template <class Walks>
struct BesideRacket : Walks {
  template <class World>
  BesideRacket(const World& world, double t, const State<Eigen::Vector3d>& /*ball*/,
               double tolerance)
      : Walks(world, t, world.seen_from_racket, tolerance) {}
};
using ExactBesideRacket = BesideRacket<ExactMethod<RacketExact, Eigen::Vector3d>>;
using ReferenceBesideRacket = BesideRacket<ReferenceMethod<RacketContacts, Eigen::Vector3d>>;

/// What a ball beside a racket in uniform motion is compared with (Truth): the closed form as far
/// as it goes; from the moment on at which the ball meets the rim, the reference. It goes from the
/// start again: up to the rim the two agree.
class RacketTruth {
 public:
  using Ball = State<Eigen::Vector3d>;
  using Exact = EventDriven<RacketExact, Eigen::Vector3d>;
  using AtRim = RacketReference;

  /// Both walks are seen from the racket of `scene`.
  RacketTruth(const Racket& scene, Exact exact, AtRim at_rim)
      : scene_(scene), exact_(std::move(exact)), at_rim_(std::move(at_rim)) {}

  bool reach(double t, long long most_events) {
    if (!is_at_rim() && !exact_.reach(t, most_events)) return false;
    return !is_at_rim() || at_rim_.reach(t, most_events);
  }
  double last_event() const { return is_at_rim() ? at_rim_.last_event() : exact_.last_event(); }
  Ball at(double t) {
    return from_ground(scene_.disc_at(t), is_at_rim() ? at_rim_.at(t) : exact_.at(t));
  }

 private:
  bool is_at_rim() const { return exact_.phases().is_at_rim(); }

  Racket scene_;
  Exact exact_;
  AtRim at_rim_;
};

/// Stage 8 without the game, for RunOf (run.hpp): a ball and a racket in uniform motion. Nothing in
/// a contact depends on who watches, so that all is computed as it is seen from the racket.
class BareRacketWorld {
 public:
  using Vector = Eigen::Vector3d;
  using Ball = State<Vector>;
  using TruthWalk = RacketTruth;
  using Methods = decltype(SteppingMethods<Vector>{} +
                           MethodList<ReferenceBesideRacket, ExactBesideRacket>{});

  RacketSetup setup;
  int side = 1;  // these two as in Racket
  bool through = false;
  Ball seen_from_racket = setup.start;

  /// The racket at time 0, in uniform motion, with the ball on its present side.
  Racket scene_now() const;
  /// The same at rest in the origin.
  Racket scene_at_rest() const;
  Disc disc(double t) const { return scene_now().disc_at(t); }

  // ---- As run.hpp asks for
  std::vector<Parameter> parameters() { return setup.parameters(); }
  Traits traits(const Simulation& simulation) const;
  Ball start(std::uint64_t /*seed*/) {
    more_pieces_ = 0;
    return setup.start;
  }
  /// Chooses the side on which the ball is, and looks at it from the racket.
  void place(double t, const Ball& ball);
  RacketExact phases() const { return RacketExact(scene_at_rest()); }
  RacketContacts contacts(double /*t*/, const Ball& seen) const { return {scene_at_rest(), seen}; }
  Truth<TruthWalk, Vector> truth(double t, const Ball& ball);

  template <class Any>
  void take_steps(Any& method, Ball& ball, long long count, double t, double dt, EnergyBook& book) {
    if (is_mine) {  // as it is seen from the ground, where the racket moves
      Racket scene = scene_now();
      for (long long i = 0; i < count; ++i) {
        whole_step(method, scene, t + static_cast<double>(i) * dt, ball, dt);
      }
      take_side_of(scene);
      seen_from_racket = seen_from(disc(t + static_cast<double>(count) * dt), ball);
      return;
    }
    Racket scene = scene_at_rest();
    // The damper's work over one piece, by the midpoint rule.
    const auto note = [&book](const Racket& law, double now, const Ball& before, const Ball& after,
                              double h) {
      if (!book.is_kept) return;
      const Ball middle{(before.position + after.position) / 2,
                        (before.velocity + after.velocity) / 2};
      book.lost -= law.damper_power(now + h / 2, middle) * h;
    };
    for (long long i = 0; i < count; ++i) {
      more_pieces_ += racket_step(method, scene, 0, seen_from_racket, dt, note).pieces - 1;
    }
    take_side_of(scene);
    ball = from_ground(disc(t + static_cast<double>(count) * dt), seen_from_racket);
  }
  double go_towards(ExactBesideRacket& method, double t, long long most_events, Ball& ball);
  double go_towards(ReferenceBesideRacket& method, double t, long long most_events, Ball& ball);
  /// A step in contact is made of pieces.
  long long more_evaluations(const Simulation& simulation) const {
    return more_pieces_ * simulation.method().evaluations;
  }

  Energy energy(double t, const Ball& ball) const { return scene_now().energy(t, ball); }
  double energy_before(const EnergyBook& book, bool by_events, double t, const Ball& ball) const;
  std::vector<double> row(double /*t*/, const Ball& ball) const {
    NumberWriter row;
    row("ball", ball);
    return row.take();
  }
  template <class Self, class Visit, class Same>
  static void remembered(Self& self, Visit& visit, Same& ball) {
    visit("ball", ball);
    visit("seen_from_racket", self.seen_from_racket);
    visit.whole("side", self.side, -1, 1);
    visit.whole("through", self.through, 0, 1);
  }

 private:
  void take_side_of(const Racket& scene) {
    side = scene.side;
    through = scene.through;
  }

  long long more_pieces_ = 0;  // of contact, than there were steps
  // When the energy book was opened, and the ball then
  double book_start_ = 0;  // s
  Ball ball_at_book_start_ = setup.start;
};

using BareRacketRun = RunOf<BareRacketWorld>;

extern template class RunOf<BareRacketWorld>;

}  // namespace bounce
