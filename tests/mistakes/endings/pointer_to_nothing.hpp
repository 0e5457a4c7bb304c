// says: your code uses memory that is not its own

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  double* volatile nothing = nullptr;
  return *nothing;
}
// [force]
