// Half of the digits get lost.
// check: the force is the weight, downwards
// told: none of the known mistakes
// seen: right to 7 digits and no further: is there a `float`

// [force]
float force(double /*t*/, const State<double>& /*state*/) const {
  return static_cast<float>(-mass * gravity);
}
// [force]
