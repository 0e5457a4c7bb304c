// Nothing new: semi-implicit Euler.
// check: in free fall it is where the formula says, whatever dt is
// told: the loop of stage 1

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  state.velocity += scene.acceleration(t, state) * dt;
  state.position += state.velocity * dt;
}
// [step]
