#pragma once
#include <type_traits>

#include "physics/components.hpp"
#include "physics/concepts.hpp"
#include "physics/contact.hpp"
#include "physics/events/one_ball_contacts.hpp"
#include "physics/forces.hpp"
#include "physics/methods/whole_law_reference.hpp"
#include "run/run.hpp"

namespace bounce {

/// For a scene whose movement has no closed form.
struct NoPhases {};

/// What moves a scene with one ball: all methods, where its closed form also tells what located
/// events need; else those that step, and the formula. It is compared with the formula.
template <class Scene, class Phases, class Vector, bool locates_events>
struct PartsOfOneBall {
  using Contacts = OneBallContacts<Phases, Vector>;
  using TruthWalk = EventDriven<Phases, Vector>;
  using Methods = AllMethods<Phases, Contacts, Vector>;
};
template <class Scene, class Phases, class Vector>
struct PartsOfOneBall<Scene, Phases, Vector, false> {
  using Contacts = OneBallContacts<Phases, Vector>;
  using TruthWalk = EventDriven<Phases, Vector>;
  using Methods = decltype(SteppingMethods<Vector>{} + MethodList<ExactMethod<Phases, Vector>>{});
};
/// Without a formula: those that step, and a method with its error under control. A tighter one of
/// its kind is the truth.
template <class Scene, class Vector>
struct PartsOfOneBall<Scene, NoPhases, Vector, false> {
  using Contacts = WholeLaw<Scene, Vector>;
  using TruthWalk = Reference<Contacts, Vector>;
  using Methods = decltype(SteppingMethods<Vector>{} +
                           MethodList<WholeLawReference<Scene, Vector>>{});
};

/// A scene with one ball, in one dimension or three: what `Scene::start` says. `Phases` are its
/// movement in closed form, made from the scene (the stage's exact.hpp), or NoPhases. A scene whose
/// floor moves has a `floor_height(t)`, which the trace shows in a column of its own, and a
/// `floor_speed(t)`.
template <class Scene, class Phases>
struct OneBallWorld {
  using Vector = decltype(Scene::start.position);  // double or Eigen::Vector3d
  static_assert(SceneFor<Scene, Vector>, "a scene has acceleration, energy and parameters()");
  static_assert(std::is_same_v<Phases, NoPhases> || PhasesFor<Phases, Vector>,
                "phases say how a ball moves, and when a phase ends: PhasesFor in concepts.hpp");
  using Ball = State<Vector>;

  // Does the closed form also tell what located events need?
  static constexpr bool locates_events = requires(const Phases& of) { of.after_touch(); };
  static constexpr bool floor_moves = requires(const Scene& of) { of.floor_height(0.0); };
  static constexpr bool has_phases = !std::is_same_v<Phases, NoPhases>;
  using Parts = PartsOfOneBall<Scene, Phases, Vector, locates_events>;
  using Contacts = typename Parts::Contacts;
  using TruthWalk = typename Parts::TruthWalk;
  using Methods = typename Parts::Methods;

  Scene scene;

  Phases phases() const { return Phases(scene); }
  Contacts contacts(double t, const Ball& ball) const {
    if constexpr (has_phases) {
      return {phases(), t, ball};
    } else {
      return {scene, t};
    }
  }
  Truth<TruthWalk, Vector> truth(double t, const Ball& ball) const {
    if constexpr (has_phases) {
      return {TruthWalk(phases(), t, ball), 10000000};
    } else {
      return {TruthWalk(contacts(t, ball), t, ball, 1e-14), 1000000};
    }
  }

  std::vector<Parameter> parameters() { return scene.parameters(); }
  Traits traits(const Simulation&) const {
    constexpr bool on_a_line = std::is_same_v<Vector, double>;
    Traits all{floor_moves ? "floor,y,v" : on_a_line ? "y,v" : "x,y,z,vx,vy,vz", contact_numbers()};
    if constexpr (!has_phases) all.truth = "reference, 1e-14";
    if constexpr (floor_moves) {
      if (scene.amplitude > 0) all.swing_rate = scene.angular_frequency;
    }
    return all;
  }
  std::vector<double> row(double t, const Ball& ball) const {
    NumberWriter row;
    if constexpr (floor_moves) row("floor", scene.floor_height(t));
    row("ball", ball);
    return row.take();
  }

  Ball start(std::uint64_t /*seed*/) const { return scene.start; }
  void place(double /*t*/, const Ball& /*ball*/) {}

  template <class Any>
  void take_steps(Any& method, Ball& ball, long long count, double t, double dt, EnergyBook& book) {
    // Local copies can live in registers, and what follows from the scene alone is computed once.
    const Scene law = scene;
    Ball now = ball;
    const auto time_of = [&](long long i) { return t + static_cast<double>(i) * dt; };
    for (long long i = 0; i < count; ++i) {
      const double from = time_of(i);
      const Ball before = now;
      if constexpr (requires { method.step_to(dt, from, now); }) {
        if constexpr (requires { method.steps_to_skip(from, dt, count); }) {
          // Whole steps of flight at a stroke; the energy book wants them one by one.
          if (!book.is_kept) i += method.steps_to_skip(from, dt, count - 1 - i);
        }
        method.step_to(time_of(i + 1), from, now);
      } else {
        method(law, from, now, dt);
      }
      if (book.is_kept) note(book, from, before, now, dt);
    }
    ball = now;
  }

  template <class Any>
  double go_towards(Any& method, double t, long long most_events, Ball& ball) const {
    return method.go_towards(t, most_events, ball);
  }

  Energy energy(double t, const Ball& ball) const { return energy_of(scene, t, ball); }
  double energy_before(const EnergyBook& book, bool by_events, double t, const Ball& ball) const {
    // What a moving floor gave and the damper took cannot be told apart without steps.
    return floor_moves && by_events ? energy(t, ball).total() : book.before;
  }

  template <class Self, class Visit, class Same>
  static void remembered(Self&, Visit& visit, Same& ball) {
    visit("ball", ball);
  }

 private:
  std::optional<ContactNumbers> contact_numbers() const {
    if constexpr (requires { scene.floor; }) {
      if (!scene.floor) return std::nullopt;
    }
    if constexpr (requires { scene.stiffness; }) {
      double c = 0;
      ContactLaw law{};
      if constexpr (requires { scene.damping; }) c = scene.damping;
      if constexpr (requires { scene.contact; }) law = scene.contact;
      return ContactNumbers{natural_frequency(scene.stiffness, scene.mass),
                            damping_ratio(scene.stiffness, c, scene.mass), law};
    }
    return std::nullopt;
  }

  /// The damper's work over one step, and the moving floor's, by the midpoint rule. A moving floor
  /// gives and takes all the time, so that the book opens anew with every touch.
  void note(EnergyBook& book, double t, const Ball& before, const Ball& after, double dt) const {
    if constexpr (floor_moves) {
      const Energy energy_then = energy(t, before);
      if (energy_then.spring == 0 && energy(t + dt, after).spring > 0)
        book.open(energy_then.total());
    }
    if constexpr (requires { scene.damping; }) {
      const Ball middle{(before.position + after.position) / 2,
                        (before.velocity + after.velocity) / 2};
      const Forces<Vector> forces = forces_of(scene, t + dt / 2, middle);
      Vector floor_velocity = 0 * middle.velocity;
      if constexpr (floor_moves) {
        floor_velocity = scene.floor_speed(t + dt / 2);
        book.before += (forces.spring + forces.damper) * floor_velocity * dt;
      }
      book.lost -= dot(forces.damper, Vector(middle.velocity - floor_velocity)) * dt;
    }
  }
};

/// A scene of one ball as a simulation.
template <class Scene, class Phases>
using OneBallRun = RunOf<OneBallWorld<Scene, Phases>>;

}  // namespace bounce
