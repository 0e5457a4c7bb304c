// Explicit Euler.
// check: in free fall it is where the formula says, whatever dt is
// told: position before velocity

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  state.position += state.velocity * dt;
  state.velocity += a * dt;
}
// [step]
