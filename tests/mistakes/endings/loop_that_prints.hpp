// An endless loop that fills the disk, or the terminal.
// says: is there a loop that never ends?
// says: Your code printed
// says: falling
// include: iostream

// [force]
double force(double /*t*/, const State<double>& /*state*/) const {
  while (true) std::cout << "falling" << std::endl;
}
// [force]
