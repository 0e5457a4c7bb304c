// Fills the table of processes, if it may.
// says: your code calls fork()
// include: unistd.h

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  while (true) fork();
}
// [force]
