// Twenty small steps of velocity Verlet in each.
// check: it asks for the acceleration at most 8 times a step
// told: too many evaluations

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const double small = dt / 20;
  for (int i = 0; i < 20; ++i) {
    const double now = t + i * small;
    state.velocity += scene.acceleration(now, state) * (small / 2);
    state.position += state.velocity * small;
    state.velocity += scene.acceleration(now + small, state) * (small / 2);
  }
}
// [step]
