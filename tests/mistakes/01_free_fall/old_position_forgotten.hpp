// = for +=.
// check: one step of the loop: acceleration, then velocity, then position
// told: none of the known mistakes
// seen: the old y is missing

// [loop]
template <class Scene, class Vector>
void fall_one_step(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector acceleration = scene.acceleration(t, state);  // from the force
  state.velocity += acceleration * dt;                       // acceleration changes velocity
  state.position = state.velocity * dt;                      // velocity changes position
}
// [loop]
