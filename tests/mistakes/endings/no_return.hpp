// An error here, a warning elsewhere.
// says: mine.hpp:
// says: no return statement

// [force]
double force(double /*t*/, const State<double>& /*state*/) const { mass* gravity; }
// [force]
