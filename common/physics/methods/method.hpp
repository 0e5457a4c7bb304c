#pragma once
#include <limits>
#include <string_view>

namespace bounce {

/// How charts mark a method's measurements.
enum class Mark { disc, triangle, square, diamond, open_diamond, triangle_down };

/// What is known of a method before it moves anything. Each method is a struct in a file of its
/// own, which holds these facts as `facts`, and
///   operator()(scene, t, state, dt)   one step of dt [s], for a method that steps, or
///   go_towards(t, most_events, state) for one that goes from event to event; it returns how far
///                                     it came [s];
///   remembered(self, visit)           what it carries from step to step, by name: it is saved,
///                                     loaded and hashed. (Only where it carries something.)
/// all_methods.hpp lists them; command line, window and report follow that list.
struct Method {
  std::string_view name;   // on the command line
  std::string_view about;  // one sentence
  int order;               // p: with half the dt the error falls by 2^p, where the law is smooth
  int evaluations;         // of the force, a step; 0: it differs, and is counted
  Mark mark = Mark::disc;
  double (*stability_limit)(double zeta) = nullptr;  // of omega0 dt (stability.hpp); null: none
  bool goes_by_events = false;                       // without a time step that the user gives

  /// The largest stable step [s] on a contact with these numbers; infinity where any step is.
  double largest_stable_step(double omega0, double zeta) const {
    return stability_limit ? stability_limit(zeta) / omega0
                           : std::numeric_limits<double>::infinity();
  }
  friend bool operator==(const Method& a, const Method& b) { return a.name == b.name; }
};

}  // namespace bounce
