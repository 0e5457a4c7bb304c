// An index that a vector refuses.
// says: your code throws an exception: vector::_M_range_check

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::vector<double> v(3);
  return v.at(5);
}
// [force]
