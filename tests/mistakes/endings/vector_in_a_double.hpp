// From stage 4 on a position is a vector, and the loop is the same.
// says: mine.hpp:
// says: A double holds one number, and this is a vector: write Vector in its place

// [loop]
template <class Scene, class Vector>
void fall_one_step(const Scene& scene, double t, State<Vector>& state, double dt) {
  double acceleration = scene.acceleration(t, state);
  state.velocity += acceleration * dt;
  state.position += state.velocity * dt;
}
// [loop]
