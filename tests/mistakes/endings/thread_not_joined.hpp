// The destructor of std::thread ends the program.
// says: a std::thread was neither joined nor detached
// include: thread

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::thread lost([] {});
  return -mass * gravity;
}
// [force]
