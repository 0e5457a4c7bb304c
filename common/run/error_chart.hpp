#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/simulation.hpp"

namespace bounce {

/// Speed against error of a scene as it is set now: its methods with a few time steps each, all run
/// anew from the start and compared with the exact solution. The work is done in small portions, so
/// that a window can do it between two frames. It knows no window.
class ErrorChart {
 public:
  struct Dot {
    Method method;
    double dt;           // s
    double evaluations;  // of the force, per simulated second
    double error;        // largest distance from the exact solution [m]; infinite if it explodes
  };
  struct Choice {
    Method method;
    double dt;
    bool operator==(const Choice&) const = default;
  };

  /// Looks at the simulation. When its parameters have changed and then stood still for `patience`
  /// calls, all is run anew; when only its method or time step has, one run is added.
  void follow(const Simulation& simulation, int patience = 15);
  /// Computes for about so long [s].
  void work(double seconds);
  bool is_done() const { return begun_ == others_.size() && !run_ && !wants_own(); }

  const std::vector<Dot>& dots() const { return dots_; }  // those that are ready
  /// What the simulation's own method and time step give; nothing while that is not known.
  std::optional<Dot> now() const;
  double duration() const { return duration_; }  // of each run [s]
  bool offers(Method method) const;
  /// Not empty when there is nothing to compare with: a sentence for the screen.
  const std::string& trouble() const { return trouble_; }

 private:
  struct Run {
    Choice choice;
    bool own;
    std::unique_ptr<Simulation> simulation;
    std::size_t sampled = 0;
    double error = 0;
  };

  void start_anew(const Simulation& simulation);
  void choose_steps();
  bool is_affordable(double dt) const;
  bool wants_own() const;
  void begin_next();
  void next_sample(Run& run);
  void finish(const Run& run);

  std::string setting_;  // the parameters that the dots belong to
  std::string seen_;     // those of the last call
  int stood_still_ = 0;
  std::unique_ptr<Simulation> start_;
  double duration_ = 0;
  std::vector<Choice> others_;  // all that shall be run, besides the simulation's own
  std::size_t begun_ = 0;       // so many of them
  std::optional<Run> run_;
  std::vector<Dot> dots_;
  std::optional<Choice> now_;  // the simulation's own
  std::optional<Dot> own_;     // its dot, where it is none of the others
  std::string trouble_;
};

}  // namespace bounce
