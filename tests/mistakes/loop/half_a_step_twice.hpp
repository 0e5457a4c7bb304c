// The position moves for half of the dt, too.
// check: in free fall it is where the formula says, whatever dt is
// told: dt / 2 twice

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  if (!acceleration) acceleration = scene.acceleration(t, state);
  const double half = dt / 2;
  state.velocity += *acceleration * half;
  state.position += state.velocity * half;
  *acceleration = scene.acceleration(t + dt, state);
  state.velocity += *acceleration * half;
}
// [step]
