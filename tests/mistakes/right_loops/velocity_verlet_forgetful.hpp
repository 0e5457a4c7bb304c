// The same without a memory.
// stage: loop
// passes
// says: 2 force evaluations a step
// says: without a damper it is velocity Verlet, or its twin.

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  state.velocity += scene.acceleration(t, state) * (dt / 2);
  state.position += state.velocity * dt;
  state.velocity += scene.acceleration(t + dt, state) * (dt / 2);
}
// [step]
