// The slope of the middle.
// stage: loop
// passes
// says: gains
// says: 2 force evaluations a step
// says: the course has none like it; it is the midpoint method, or its twin.

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> middle{state.position + state.velocity * (dt / 2),
                             state.velocity + a * (dt / 2)};
  state.position += middle.velocity * dt;
  state.velocity += scene.acceleration(t + dt / 2, middle) * dt;
}
// [step]
