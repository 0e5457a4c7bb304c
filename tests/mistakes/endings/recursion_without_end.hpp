// The result is used after the call, so that no compiler makes a loop of it.
// says: a function calls itself again and again

// [force]
double force_again(double x) const { return force_again(x + 1) + mass; }
double force(double /*t*/, const State<double>& /*state*/) const {
  return mass * gravity + force_again(1);
}
// [force]
