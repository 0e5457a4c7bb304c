// Explicit Euler, where the lesson asks for semi-implicit Euler.
// check: one step of the loop: acceleration, then velocity, then position
// told: position before velocity

// [loop]
template <class Scene, class Vector>
void fall_one_step(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector acceleration = scene.acceleration(t, state);  // from the force
  state.position += state.velocity * dt;
  state.velocity += acceleration * dt;
}
// [loop]
