// A warning about the learner's line, beside the verdict.
// says: not yet
// says: The compiler warns
// says: mine.hpp:
// says: unused variable

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  double weight = mass * gravity;
  return 0;
}
// [force]
