// Half a kick, a drift, half a kick.
// stage: loop
// passes
// says: order 2.0
// says: with a damper
// says: keeps the energy
// says: 1 force evaluation a step
// says: it is velocity Verlet, or its twin.

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  if (!acceleration) acceleration = scene.acceleration(t, state);
  state.velocity += *acceleration * (dt / 2);
  state.position += state.velocity * dt;
  *acceleration = scene.acceleration(t + dt, state);
  state.velocity += *acceleration * (dt / 2);
}
// [step]
