// Both ends, and nobody divides by 2.
// check: in free fall it is where the formula says, whatever dt is
// told: a sum in place of a mean

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> end{state.position + state.velocity * dt, state.velocity + a * dt};
  state.position += (state.velocity + end.velocity) * dt;
  state.velocity += (a + scene.acceleration(t + dt, end)) * dt;
}
// [step]
