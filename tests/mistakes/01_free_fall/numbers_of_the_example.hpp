// Right for mass 1 and gravity 9.81.
// check: the force is the weight, downwards
// told: the example's numbers

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  return -9.81;  // downwards, so negative: y is up
}
// [force]
