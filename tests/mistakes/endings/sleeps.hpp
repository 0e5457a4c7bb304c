// Not an endless loop: it waits.
// says: your code waits for something that does not come
// include: thread
// include: chrono

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  std::this_thread::sleep_for(std::chrono::hours(1));
  return -mass * gravity;
}
// [force]
