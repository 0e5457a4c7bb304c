// says: does not compile yet
// says: mine.hpp:
// says: gravitty

// [force]
double force(double /*t*/, const State<double>& /*state*/) const { return -mass * gravitty; }
// [force]
