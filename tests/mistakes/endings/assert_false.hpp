// says: an assert that is not true
// says: Your code printed
// says: Assertion
// include: cassert

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  assert(mass < 0);
  return -mass * gravity;
}
// [force]
