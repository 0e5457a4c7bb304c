// The law is not asked.
// check: the laws: touches(y, floor) and damped_velocity(t, v)
// told: relative whatever the law

// [laws]
bool touches(double y, double floor) const {
  // The slides' switch: wherever the floor is.
  if (floor_law == FloorLaw::fixed_switch) return y < radius;
  return y - floor < radius;
}
double damped_velocity(double t, double v) const {
  return v - floor_speed(t);
  // Whatever the floor does.
  return v;
}
// [laws]
