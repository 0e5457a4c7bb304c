// cos(w t) is not yet the derivative of sin(w t).
// check: the floor's speed is the derivative of its height
// told: w forgotten

// [floor]
double floor_height(double t) const {
  return floor_velocity * t + amplitude * std::sin(angular_frequency * t + phase);
}
// Its derivative.
double floor_speed(double t) const {
  return floor_velocity + amplitude * std::cos(angular_frequency * t + phase);
}
// [floor]
