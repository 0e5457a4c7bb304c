// The slides' switch, where the lesson asks for the floor.
// check: the laws: touches(y, floor) and damped_velocity(t, v)
// told: contact tested at y < r on a moving floor

// [laws]
bool touches(double y, double floor) const {
  // The slides' switch: wherever the floor is.
  if (floor_law == FloorLaw::fixed_switch) return y < radius;
  return y < radius;
}
double damped_velocity(double t, double v) const {
  if (floor_law == FloorLaw::relative) return v - floor_speed(t);
  // Whatever the floor does.
  return v;
}
// [laws]
