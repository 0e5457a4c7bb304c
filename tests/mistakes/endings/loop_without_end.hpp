// The counter never gets there.
// says: is there a loop that never ends?

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  volatile int i = 0;
  while (i < 10) i = 0;
  return -mass * gravity;
}
// [force]
