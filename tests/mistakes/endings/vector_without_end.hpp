// Takes all memory, if it may.
// says: is there a vector that grows without end?

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::vector<double> all;
  while (true) all.push_back(mass);
}
// [force]
