// The answer is right, and the thread goes on.
// says: a thread that your code started is still running
// include: thread
// include: chrono

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  static bool once = false;
  if (!once) std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
  once = true;
  return -mass * gravity;
}
// [force]
