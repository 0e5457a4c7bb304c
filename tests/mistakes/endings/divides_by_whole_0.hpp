// A fraction of whole numbers, with 0 below.
// says: your code divided a whole number by 0

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  const int parts = static_cast<int>(mass / 1000);
  return -mass * gravity * (1 / parts);
}
// [force]
