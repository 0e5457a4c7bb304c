// The midpoint method with a middle that is a whole dt away.
// check: in free fall it is where the formula says, whatever dt is
// told: a middle that is the end

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector a = scene.acceleration(t, state);
  const State<Vector> middle{state.position + state.velocity * dt, state.velocity + a * dt};
  state.position += middle.velocity * dt;
  state.velocity += scene.acceleration(t + dt / 2, middle) * dt;
}
// [step]
