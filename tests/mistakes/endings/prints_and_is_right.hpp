// A line left from looking for a mistake, in a right solution.
// says: ok       the force is the weight
// says: Your code printed
// says: the table of speeds is left out
// passes
// include: iostream

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::cout << "force " << mass * gravity << "\n";
  return -mass * gravity;
}
// [force]
