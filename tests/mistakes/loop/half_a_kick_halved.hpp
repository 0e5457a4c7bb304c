// dt is half a step already, and is halved again.
// check: in free fall it is where the formula says, whatever dt is
// told: dt / 2 twice

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const double half = dt / 2;
  state.velocity += scene.acceleration(t, state) * (half / 2);
  state.position += state.velocity * dt;
  state.velocity += scene.acceleration(t + dt, state) * (half / 2);
}
// [step]
