// Explicit Euler, where the lesson asks for semi-implicit Euler.
// check: one step of the loop: acceleration, then velocity, then position
// told: position before velocity

// [loop]
template <class Scene>
void fall_one_step(const Scene& scene, double t, State<double>& state, double dt) {
  const double acceleration = scene.acceleration(t, state);  // from the force
  state.position += state.velocity * dt;
  state.velocity += acceleration * dt;
}
// [loop]
