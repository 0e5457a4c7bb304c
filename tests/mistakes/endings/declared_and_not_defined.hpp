// The linker's words are not a beginner's.
// says: mine.hpp:
// says: weight() const is declared and used, and nowhere is it said what it does

// [force]
double weight() const;
double force(double /*t*/, const State<double>& /*state*/) const { return -weight(); }
// [force]
