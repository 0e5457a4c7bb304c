#pragma once
#include <array>

#include "physics/methods/exact.hpp"
#include "physics/methods/explicit_euler.hpp"
#include "physics/methods/flight_rk4.hpp"
#include "physics/methods/mine.hpp"
#include "physics/methods/reference.hpp"
#include "physics/methods/rk4.hpp"
#include "physics/methods/rk4_events.hpp"
#include "physics/methods/semi_implicit_euler.hpp"
#include "physics/methods/velocity_verlet.hpp"

namespace bounce {

// The one list of methods, in the order in which they are shown. A run offers those parts of it
// that its scene allows: the stepping methods always, the others where there are closed forms.

template <class Vector>
using SteppingMethods =
    decltype(MethodList<ExplicitEuler, SemiImplicitEuler, VelocityVerlet<Vector>, Rk4>{} +
             MyMethods<Vector>{});

template <class Phases, class Vector>
using LocatedMethods = MethodList<Rk4Events<Phases, Vector>, FlightRk4<Phases, Vector>>;

/// Those of a scene with one ball, for which there are closed forms.
template <class Phases, class Contacts, class Vector>
using AllMethods =
    decltype(SteppingMethods<Vector>{} + LocatedMethods<Phases, Vector>{} +
             MethodList<ReferenceMethod<Contacts, Vector>, ExactMethod<Phases, Vector>>{});

}  // namespace bounce
