// The mean of both ends.
// stage: loop
// passes
// says: gains
// says: 2 force evaluations a step
// says: the course has none like it; it is Heun's method, or its twin.

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> end{state.position + state.velocity * dt, state.velocity + a * dt};
  state.position += (state.velocity + end.velocity) * (dt / 2);
  state.velocity += (a + scene.acceleration(t + dt, end)) * (dt / 2);
}
// [step]
