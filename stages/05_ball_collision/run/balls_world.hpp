#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "05_ball_collision/ball_collision.hpp"
#include "05_ball_collision/reference/ball_contacts.hpp"
#include "05_ball_collision/scenes/scenes.hpp"
#include "many_balls/lammps_import.hpp"
#include "many_balls/many_balls.hpp"
#include "physics/methods/all_methods.hpp"
#include "run/run.hpp"
#include "run/whose_lines.hpp"

namespace bounce {

// The reference steps all balls from event to event, and a heap has as many events as contacts: a
// method for some balls.
inline constexpr std::size_t most_balls_of_reference = 1000;
inline constexpr const char* why_not_so_many =
    "the method reference steps all balls at every event, and takes at most 1000 balls";

/// Stage 5 for RunOf (run.hpp): the balls of a built-in scene, or those of a file.
class BallsWorld {
 public:
  using Vector = Eigen::Matrix3Xd;
  using Balls = State<Vector>;
  using TruthWalk = Reference<BallContacts, Vector>;
  using Methods = decltype(SteppingMethods<Vector>{} +
                           MethodList<ReferenceMethod<BallContacts, Vector>>{});

  BallsWorld() { choose_scene(BallScene::pair); }

  BallCollision scene;
  SceneChoice choice;
  std::shared_ptr<const Arrangement> own_balls;  // of a file, in place of the scene's; or none
  std::string origin;                            // the option that brought them
  int threads = 1;  // for many balls. The result is the same, to the bit.
  /// From so many balls on, the steps of semi-implicit Euler and velocity Verlet are taken by
  /// many::ManyBalls, which is faster (see docs/deeper) and gives the same bits.
  static constexpr Eigen::Index many_from = 32;
  std::uint64_t seed = 1;  // of the last start

  /// A scene brings the parameters that suit it; whoever wants others sets them after it. Its balls
  /// come with the next start.
  void choose_scene(BallScene scene);
  void use_balls(Arrangement balls, const std::string& from);
  /// These balls are the start from now on, and their masses and radii hold at once.
  void take_over(Arrangement balls, const std::string& from);
  many::Laws laws() const {
    return {scene.gravity, scene.pair_contact(), scene.floor_contact(), scene.floor, scene.tray};
  }

  // ---- As run.hpp asks for
  std::vector<Parameter> parameters();
  Traits traits(const Simulation& simulation) const;
  Balls start(std::uint64_t seed);
  void place(double /*t*/, const Balls& /*balls*/) {}
  BallContacts contacts(double /*t*/, const Balls& balls) const { return {scene, balls}; }
  Truth<TruthWalk, Vector> truth(double t, const Balls& balls) const;

  Energy energy(double /*t*/, const Balls& balls) const { return scene.energy(balls); }
  double energy_before(const EnergyBook& book, bool, double, const Balls&) const {
    return book.before;
  }
  std::vector<double> row(double t, const Balls& balls) const;  // for each ball

  template <class Any>
  void take_steps(Any& method, Balls& balls, long long count, double t, double dt,
                  EnergyBook& book) {
    constexpr bool is_verlet = std::is_same_v<Any, VelocityVerlet<Vector>>;
    const auto many_steps = [&](long long steps) {
      std::optional<Vector> none;
      std::optional<Vector>& acceleration = [&]() -> std::optional<Vector>& {
        if constexpr (is_verlet) return method.acceleration;
        return none;
      }();
      if (!acceleration) acceleration.emplace(3, 0);
      many_.move(laws(), scene.mass, scene.radius, balls, *acceleration,
                 is_verlet ? many::Stepping::velocity_verlet : many::Stepping::semi_implicit_euler,
                 steps, dt, threads);
    };
    // Not on a learner's lines: there only his law moves the balls, however many.
    const bool is_many =
        !is_mine &&
        (is_verlet || std::is_same_v<Any, SemiImplicitEuler>)&&scene.mass.size() >= many_from;
    if (is_many && !book.is_kept) return many_steps(count);
    Balls middle;
    for (long long i = 0; i < count; ++i) {
      if (book.is_kept) middle = balls;
      if (is_many) {
        many_steps(1);
      } else {
        method(scene, t + static_cast<double>(i) * dt, balls, dt);
      }
      if (!book.is_kept) continue;
      // The dampers' work over the step, by the midpoint rule.
      middle.position = (middle.position + balls.position) / 2;
      middle.velocity = (middle.velocity + balls.velocity) / 2;
      book.lost += scene.damper_power(middle) * dt;
    }
  }

  template <class Any>
  double go_towards(Any& method, double t, long long most_events, Balls& balls) const {
    if (count() > most_balls_of_reference) {
      throw NoClosedForm(method.walk.last_event(), why_not_so_many);
    }
    // So many that one can be heard in between.
    const auto balls_a_step = static_cast<long long>(count());
    return method.go_towards(t, std::max(1LL, most_events / balls_a_step), balls);
  }

  /// How many balls, whether they came from a file, and the seed; masses, radii, positions,
  /// velocities; the start of balls from a file.
  template <class Self, class Visit, class Same>
  static void remembered(Self& self, Visit& visit, Same& balls) {
    Eigen::Index count = self.scene.mass.size();
    bool own = self.own_balls != nullptr;
    visit.whole("count", count, 1, 1'000'000'000);
    visit.whole("own_balls", own, 0, 1);
    visit.whole("seed", self.seed, 0, 1'000'000'000'000'000);
    if constexpr (Visit::reads) {
      if (visit.left() < static_cast<std::size_t>(count) * (own ? 14 : 8)) {
        return visit.refuse("there are too few numbers");
      }
      Arrangement now(count);
      visit("mass", now.mass);
      visit("radius", now.radius);
      visit("balls", now.balls);
      if (!(now.mass.array() > 0).all()) visit.refuse("mass");
      if (!(now.radius.array() > 0).all()) visit.refuse("radius");
      self.scene.mass = now.mass;
      self.scene.radius = now.radius;
      balls = now.balls;
      if (own) visit("start", now.balls);
      self.own_balls = own ? std::make_shared<const Arrangement>(now) : nullptr;
    } else {
      visit("mass", self.scene.mass);
      visit("radius", self.scene.radius);
      visit("balls", balls);
      if (own) visit("start", self.own_balls->balls);
    }
  }

 private:
  /// The contact that asks for the smallest time step.
  std::optional<ContactNumbers> hardest_contact() const;
  std::size_t count() const { return static_cast<std::size_t>(scene.mass.size()); }

  std::array<double, 2> tray_of_scene_{};  // while `tray` is still this, it follows the count
  many::ManyBalls many_;
};

using BallsRun = RunOf<BallsWorld>;

/// Goes on from balls that another program has moved, as if this run had done it. Masses and radii
/// stay those of the scene where the frame has none. Throws BadInput when that cannot be.
void continue_from(BallsRun& run, const many::LammpsFrame& frame, const std::string& origin);

extern template class RunOf<BallsWorld>;

}  // namespace bounce
