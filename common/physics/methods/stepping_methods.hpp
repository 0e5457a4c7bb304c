#pragma once
// The four methods that move any scene by steps of dt. They all solve the same equation,
// x'' = a(t, x, x'), with the acceleration that the scene tells,
//
//   Vector scene.acceleration(double t, const State<Vector>& state) const     [m/s^2]
//
// and differ in when they ask for it, and so in what an error of theirs looks like.
// "Order p" means: halve dt, and the error after a given time falls by 2^p - as long as the
// acceleration is smooth. A touch of the floor is not smooth (docs/deeper/02_spring_floor.md).
#include "physics/methods/explicit_euler.hpp"
#include "physics/methods/rk4.hpp"
#include "physics/methods/semi_implicit_euler.hpp"
#include "physics/methods/velocity_verlet.hpp"
