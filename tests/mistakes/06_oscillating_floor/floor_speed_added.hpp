// Minus is forgotten, and so is the table.
// check: the laws: touches(y, floor) and damped_velocity(t, v)
// told: the floor's speed is added
// seen: too much: the floor's speed where it does not count

// [laws]
bool touches(double y, double floor) const {
  // The slides' switch: wherever the floor is.
  if (floor_law == FloorLaw::fixed_switch) return y < radius;
  return y - floor < radius;
}
double damped_velocity(double t, double v) const { return v + floor_speed(t); }
// [laws]
