// The floor starts at the top of its swing.
// check: the floor is at floor_velocity t + A sin(w t + phase)
// told: cos instead of sin

// [floor]
double floor_height(double t) const {
  return floor_velocity * t + amplitude * std::cos(angular_frequency * t + phase);
}
// Its derivative.
double floor_speed(double t) const {
  return floor_velocity + amplitude * angular_frequency * std::cos(angular_frequency * t + phase);
}
// [floor]
