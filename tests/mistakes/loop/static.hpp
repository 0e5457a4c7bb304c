// One memory for all that this ever moves.
// check: in free fall it is where the formula says, whatever dt is
// told: none of the known mistakes
// seen: the same question, asked twice, got two answers

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  static Vector kept = scene.acceleration(t, state);
  state.velocity += kept * (dt / 2);
  state.position += state.velocity * dt;
  kept = scene.acceleration(t + dt, state);
  state.velocity += kept * (dt / 2);
}
// [step]
