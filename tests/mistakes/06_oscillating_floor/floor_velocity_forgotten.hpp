// The swing alone.
// check: the floor is at floor_velocity t + A sin(w t + phase)
// told: floor_velocity forgotten

// [floor]
double floor_height(double t) const { return amplitude * std::sin(angular_frequency * t + phase); }
// Its derivative.
double floor_speed(double t) const {
  return floor_velocity + amplitude * angular_frequency * std::cos(angular_frequency * t + phase);
}
// [floor]
