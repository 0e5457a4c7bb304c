// An exception that nobody catches.
// says: your code throws an exception: no idea
// include: stdexcept

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  throw std::runtime_error("no idea");
}
// [force]
