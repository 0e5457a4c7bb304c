// A factor that no name has.
// check: in free fall it is where the formula says, whatever dt is
// told: none of the known mistakes
// seen: g t dt (in y)

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  state.position += state.velocity * dt + a * (dt * dt);
  state.velocity += (a + scene.acceleration(t + dt, state)) * (dt / 2);
}
// [step]
