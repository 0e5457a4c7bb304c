// Only the acceleration is that of the middle.
// check: in free fall it is where the formula says, whatever dt is
// told: the old velocity

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> middle{state.position + state.velocity * (dt / 2),
                             state.velocity + a * (dt / 2)};
  state.position += state.velocity * dt;
  state.velocity += scene.acceleration(t + dt / 2, middle) * dt;
}
// [step]
