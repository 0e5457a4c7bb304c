// The slides' switch, where the lesson asks for the floor.
// check: above the moving floor only gravity acts
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
