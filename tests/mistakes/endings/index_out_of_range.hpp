// An index that nobody checks, without the checks' flags.
// says: an index outside of a vector

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::vector<double> v(3);
  return v[5];
}
// [force]
