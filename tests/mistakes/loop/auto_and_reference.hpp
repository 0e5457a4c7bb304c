// The second answer of stage 5 takes the place of the first.
// check: it moves a vector as it moves each of its numbers
// told: none of the known mistakes

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const auto& a = scene.acceleration(t, state);
  const State<Vector> end{state.position + state.velocity * dt, state.velocity + a * dt};
  const auto& b = scene.acceleration(t + dt, end);
  state.position += (state.velocity + end.velocity) * (dt / 2);
  state.velocity += (a + b) * (dt / 2);
}
// [step]
