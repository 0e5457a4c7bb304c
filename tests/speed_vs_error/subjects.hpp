#pragma once
#include <functional>
#include <string>
#include <vector>

namespace bounce::report {

/// The numbers of a state: positions, then as many velocities. Where only the running simulation
/// knows the energy, that is one more number at the end.
using Row = std::vector<double>;

/// What was measured of one subject. Not a number: not measured.
struct Result {
  std::string case_name;
  int stage;
  std::string method, knob;
  double value;
  bool is_peer;
  double position_error, velocity_error, energy_drift;  // maxima over the times; m, m/s, relative
  double top_error, top_time_error;  // of six bounces: heights, relative; time of the last, s
  double cost, evaluations;          // us of CPU time and force calls, per second
};

/// One method with one time step or tolerance, on one case.
struct Subject {
  std::string method;
  std::string knob;  // "dt" [s], "tolerance", or empty
  double value;
  bool is_peer;
  std::function<std::vector<Row>(const std::vector<double>& times)> sample;  // the states then
  std::function<double()> run;               // to the end of the case and nothing else
  std::function<long long()> evaluations{};  // of the force, in one run
  std::function<void(Result&)> judge{};      // fills in the errors, in place of the case's truth
  int balls = 1;                             // that one run moves; cost is given for one of them
};

/// A scene, how long it runs, and all that is measured on it.
struct Case {
  std::string name;  // one word, as in the CSV
  int stage;
  std::string what;
  double t_end;  // s
  std::vector<double> times;
  std::vector<Row> truth;                                // at those times
  std::function<double(double t, const Row&)> energy{};  // [J]
  std::vector<Subject> subjects{};
};

/// The cases with the course's own methods (own_methods.cpp).
std::vector<Case> cases();

/// Adds those of the stages that have a Simulation class of their own (simulated_cases.cpp).
void add_simulated_cases(std::vector<Case>& all);

/// Adds other programs' methods to the cases "bounce" and "damped" (peers_*.cpp). Where a peer was
/// not installed when CMake looked, its function adds nothing.
void add_odeint(Case& on, double damping);
void add_cvode(Case& on, double damping);

/// Time steps, or tolerances, from coarse to fine: `each` per power of ten.
std::vector<double> geometric(double coarsest, double finest, int each);

}  // namespace bounce::report
