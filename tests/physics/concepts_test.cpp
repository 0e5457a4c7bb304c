// What fits the concepts, and what does not: told by the compiler. Each of the wrong types lacks
// one thing, or has it with a wrong type.

#include "physics/concepts.hpp"

#include "01_free_fall/exact.hpp"
#include "03_damping/exact.hpp"
#include "04_three_dimensions/exact.hpp"
#include "05_ball_collision/reference/ball_contacts.hpp"
#include "06_oscillating_floor/exact/exact.hpp"
#include "07_tilted_plane/exact.hpp"
#include "08_racket_game/exact/exact.hpp"
#include "08_racket_game/reference/racket_contacts.hpp"
#include "physics/events/located_events.hpp"
#include "physics/events/one_ball_contacts.hpp"
#include "physics/events/reference_walk.hpp"

using namespace bounce;
using Eigen::Matrix3Xd, Eigen::Vector3d;

namespace {

static_assert(SceneFor<FreeFall, double> && SceneFor<Damping, double>);
static_assert(SceneFor<OscillatingFloor, double> && SceneFor<TiltedPlane, Vector3d>);
static_assert(!SceneFor<ThreeDimensions, double>);  // of another dimension
static_assert(!SceneFor<int, double>);

struct NoEnergy {
  double acceleration(double, const State<double>&) const { return 0; }
  std::vector<Parameter> parameters() { return {}; }
};
struct WithEnergy : NoEnergy {
  Energy energy(const State<double>&) const { return {}; }
};
struct NoForce : WithEnergy {
  void acceleration(double, const State<double>&) const {}
};
struct NoParameters : WithEnergy {
  void parameters() {}
};
static_assert(SceneFor<WithEnergy, double> && !SceneFor<NoEnergy, double>);
static_assert(!SceneFor<NoForce, double> && !SceneFor<NoParameters, double>);

static_assert(PhasesFor<FreeFallExact, double> && PhasesFor<RacketExact, Vector3d>);
static_assert(LocatedPhasesFor<DampingExact, double>);
static_assert(LocatedPhasesFor<OscillatingFloorExact, double>);
static_assert(LocatedPhasesFor<ThreeDimensionsExact, Vector3d>);
static_assert(LocatedPhasesFor<TiltedPlaneExact, Vector3d>);
static_assert(!LocatedPhasesFor<FreeFallExact, double>);  // it knows no touch
static_assert(!PhasesFor<DampingExact, Vector3d>);        // of another dimension

struct NeverEnds : FreeFallExact {
  double end_of(Phase, const State<double>&) const { return never; }  // and what comes next?
};
struct StandsStill : FreeFallExact {
  void move(Phase, const State<double>&, double) const {}
};
struct NoBound : DampingExact {
  void max_bend() const {}
};
static_assert(!PhasesFor<NeverEnds, double> && !PhasesFor<StandsStill, double>);
static_assert(PhasesFor<NoBound, double> && !LocatedPhasesFor<NoBound, double>);

using OfOneBall = OneBallContacts<DampingExact, double>;
static_assert(ContactsFor<OfOneBall, double> && ContactsFor<BallContacts, Matrix3Xd>);
static_assert(ContactsFor<RacketContacts, Vector3d>);
static_assert(!ContactsFor<OfOneBall, Vector3d> && !ContactsFor<BallContacts, Vector3d>);
static_assert(!ContactsFor<DampingExact, double>);  // phases are no contacts

struct OnlyValue : OfOneBall {
  double event_value(Event, double, const State<double>&, double) const { return 1; }  // no slope
};
struct OtherEvents : OfOneBall {
  std::vector<int> events(const State<double>&, double) const { return {}; }
};
struct NeverResolves : OfOneBall {
  void resolves() const {}
};
static_assert(!ContactsFor<OnlyValue, double> && !ContactsFor<OtherEvents, double>);
static_assert(!ContactsFor<NeverResolves, double>);

// A template that is entered with the wrong thing says so at the door.
template <class Phases, class Vector>
concept Walks = requires {
  typename EventDriven<Phases, Vector>;
};
template <class Phases, class Vector>
concept Locates = std::constructible_from < LocatedEvents<Phases, Vector>,
const Phases&, double, const State<Vector>& > ;
template <class Contacts, class Vector>
concept Refers = std::constructible_from < Reference<Contacts, Vector>,
const Contacts&, double, const State<Vector>&, double > ;

static_assert(Walks<FreeFallExact, double> && !Walks<NeverEnds, double>);
static_assert(Locates<DampingExact, double> && !Locates<FreeFallExact, double>);
static_assert(Refers<OfOneBall, double> && !Refers<OtherEvents, double>);

}  // namespace
