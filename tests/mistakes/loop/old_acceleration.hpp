// The second half of the step goes by the acceleration of the first.
// check: with half of the dt, a quarter of the error or less: order 2
// told: the old acceleration

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  state.velocity += a * (dt / 2);
  state.position += state.velocity * dt;
  state.velocity += a * (dt / 2);
}
// [step]
