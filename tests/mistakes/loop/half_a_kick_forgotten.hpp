// Velocity Verlet without its second half kick.
// check: in free fall it is where the formula says, whatever dt is
// told: half a kick forgotten

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  if (!acceleration) acceleration = scene.acceleration(t, state);
  state.velocity += *acceleration * (dt / 2);
  state.position += state.velocity * dt;
  *acceleration = scene.acceleration(t + dt, state);
}
// [step]
