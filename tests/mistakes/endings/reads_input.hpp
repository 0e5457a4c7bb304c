// Nobody types.
// says: Your code reads from std::cin. Nobody types here
// include: iostream

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  double g = 0;
  std::cin >> g;
  return -mass * g;
}
// [force]
