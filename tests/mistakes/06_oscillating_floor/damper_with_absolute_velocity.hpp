// The result depends on who watches.
// check: the laws: touches(y, floor) and damped_velocity(t, v)
// told: damper with absolute velocity

// [laws]
bool touches(double y, double floor) const {
  // The slides' switch: wherever the floor is.
  if (floor_law == FloorLaw::fixed_switch) return y < radius;
  return y - floor < radius;
}
double damped_velocity(double t, double v) const {
  if (floor_law == FloorLaw::relative) return v;
  // Whatever the floor does.
  return v;
}
// [laws]
