// Ralston: the slope at two thirds counts three times.
// stage: loop
// passes
// says: it does what no method of the course does.

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const double h = dt * 2 / 3;
  const State<Vector> there{state.position + state.velocity * h, state.velocity + a * h};
  state.position += (state.velocity + 3 * there.velocity) * (dt / 4);
  state.velocity += (a + 3 * scene.acceleration(t + h, there)) * (dt / 4);
}
// [step]
