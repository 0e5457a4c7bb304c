// And this is what one that failed would.
// says: your code ended the whole program, with exit(1)
// include: cstdlib

// [force]
double force(double /*t*/, const State<double>& /*state*/) const { std::exit(1); }
// [force]
