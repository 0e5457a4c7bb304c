// The result depends on who watches.
// check: in contact: k (r - y + floor) - c (v - floor speed)
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
