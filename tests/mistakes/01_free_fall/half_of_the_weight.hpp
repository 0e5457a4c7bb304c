// A factor that no name has.
// check: the force is the weight, downwards
// told: none of the known mistakes
// seen: your answer is 0.5 times the right one

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  return -mass * gravity / 2;  // downwards, so negative: y is up
}
// [force]
