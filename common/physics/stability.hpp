#pragma once

namespace bounce {

// How large may a time step be? During a contact the ball is a damped oscillator,
// x'' + 2 zeta omega0 x' + omega0^2 x = 0, and one step of a method multiplies (x, v) by a fixed
// matrix. The method is stable while no eigenvalue of that matrix is larger than 1 in magnitude.
// The functions return that limit as omega0 dt, a pure number, for a damping ratio zeta >= 0.
// Above it the ball is thrown out of the floor with more and more energy. Well below it a bounce
// can still be wrong by some percent: stable is not accurate (docs/deeper/02_spring_floor.md).

/// Explicit Euler. Its eigenvalues are 1 + lambda dt; on an undamped spring their squared magnitude
/// is 1 + (omega0 dt)^2, so that no step is stable and the limit is 0.
double explicit_euler_limit(double zeta);

/// Semi-implicit Euler with the damper taken explicitly, as in the slides' loop:
/// omega0 dt < 2 (sqrt(1 + zeta^2) - zeta). The textbook's "2" is the case zeta = 0.
/// Velocity Verlet with the half-step velocity has the same limit: seen from half step to half step
/// it is the same map.
double semi_implicit_euler_limit(double zeta);

/// Classical Runge-Kutta: |1 + z + z^2/2 + z^3/6 + z^4/24| <= 1 for z = lambda dt, found by
/// bisection; 2 sqrt(2) at zeta = 0.
double rk4_limit(double zeta);

/// The largest step [s] with which a bounce's restitution is right to within `accuracy` (absolute,
/// from 0 to 1), whatever the moment at which the ball touches, with the slides' loop. With
/// w = omega0 dt an undamped bounce is bounded by sqrt(1 - w^2/4) and its inverse, because the loop
/// keeps v^2 + x^2 - w x v (omega0 = 1): about w^2 / 8 to each side. With a damper, a contact that
/// is seen up to a step too long loses besides up to 4 zeta w of the restitution (measured: 3.4
/// at most, up to zeta = 0.6; tests/hard_cases/stability_map_test.cpp).
double restitution_step(double omega0, double zeta, double accuracy);

/// A step that is good enough to look at [s]: a twentieth of the largest stable step of the slides'
/// loop, so omega0 dt = 0.1 without damping, or less where the restitution would not be right to
/// 0.01. Undamped it is then 1 +- 0.0012. This is what `--dt auto` uses.
double comfortable_step(double omega0, double zeta);

}  // namespace bounce
