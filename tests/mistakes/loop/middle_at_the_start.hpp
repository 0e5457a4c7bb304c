// The midpoint method, with the time of the start.
// check: with half of the dt, a quarter of the error or less: order 2
// told: time stands still

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> middle{state.position + state.velocity * (dt / 2),
                             state.velocity + a * (dt / 2)};
  state.position += middle.velocity * dt;
  state.velocity += scene.acceleration(t, middle) * dt;
}
// [step]
