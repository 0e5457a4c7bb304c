// As in the slides' first program: a = g.
// check: the force is the weight, downwards
// told: gravity points up

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  return mass * gravity;  // downwards, so negative: y is up
}
// [force]
