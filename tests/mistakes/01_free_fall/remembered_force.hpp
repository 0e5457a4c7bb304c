// A sum that is never set back.
// check: the force is the weight, downwards
// told: none of the known mistakes
// seen: the same question, asked twice, got two answers

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  static double force = 0;
  force -= mass * gravity;
  return force;  // downwards, so negative: y is up
}
// [force]
