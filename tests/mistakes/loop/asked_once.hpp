// What is remembered is never renewed.
// check: with half of the dt, a quarter of the error or less: order 2
// told: asked once, and never again

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  if (!acceleration) acceleration = scene.acceleration(t, state);
  state.velocity += *acceleration * (dt / 2);
  state.position += state.velocity * dt;
  state.velocity += *acceleration * (dt / 2);
}
// [step]
