// The force is asked for again only if it has just changed.
// check: on a spring floor it still bounces after 10 000 bounces
// told: not asked in the air

// [step]
template <class Scene>
void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
  static Vector old;
  const bool is_first = !acceleration;
  if (is_first) acceleration = scene.acceleration(t, state);
  state.velocity += *acceleration * (dt / 2);
  state.position += state.velocity * dt;
  const Vector before = *acceleration;
  if (is_first || before != old) acceleration = scene.acceleration(t + dt, state);
  old = before;
  state.velocity += *acceleration * (dt / 2);
}
// [step]
