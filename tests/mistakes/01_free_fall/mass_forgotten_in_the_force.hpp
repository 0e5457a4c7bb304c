// An acceleration in place of a force.
// check: the force is the weight, downwards
// told: mass forgotten

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  return -gravity;  // downwards, so negative: y is up
}
// [force]
