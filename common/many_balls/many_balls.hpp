#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "many_balls/neighbour_list.hpp"
#include "many_balls/pass.hpp"
#include "physics/state.hpp"

namespace bounce::many {

enum class Stepping { semi_implicit_euler, velocity_verlet };

/// Moves many balls: the same laws and methods as the plain loop of stage 5, and the same results
/// to the last bit, some twenty times faster.
///
/// What makes it fast: neighbour lists that hold for many steps, vector units that do eight balls
/// at once, threads, one pass over the memory in a step. The results depend on none of that,
/// because each ball adds up the forces on it for itself, always in the order of the double loop.
class ManyBalls {
 public:
  using Matrix = Eigen::Matrix3Xd;

  ManyBalls() = default;
  // What is kept between two calls is memory, not knowledge: a copy starts without.
  ManyBalls(const ManyBalls& other) : pass_(other.pass_) {}
  ManyBalls& operator=(const ManyBalls& other) {
    if (this != &other) *this = ManyBalls(other);
    return *this;
  }
  ManyBalls(ManyBalls&&) = default;
  ManyBalls& operator=(ManyBalls&&) = default;
  ~ManyBalls() = default;

  /// Moves the balls on by `count` steps of `dt` [s]. `acceleration` is what velocity Verlet
  /// carries from step to step: at the end of the step before [m/s^2]; empty (0 columns) before the
  /// first.
  void move(const Laws& laws, const Eigen::VectorXd& mass, const Eigen::VectorXd& radius,
            State<Matrix>& balls, Matrix& acceleration, Stepping stepping, long long count,
            double dt, int threads = 1);

  /// Another variant of the pass than the fastest one, for tests and measurements.
  void use_pass(PassFunction variant) { pass_ = variant; }

  long long lists_built() const { return lists_built_; }
  std::size_t bytes() const;  // what is kept between two calls

 private:
  void load(const Eigen::VectorXd& mass, const Eigen::VectorXd& radius, const State<Matrix>& balls);
  void store(State<Matrix>& balls) const;
  void pass(const Pass& what, Team& team);

  PassFunction pass_ = fastest_pass();
  NeighbourList list_;
  std::vector<BallRecord> now_, next_;  // one for each slot, and nobody at the end
  std::vector<int> number_;             // of each slot
  double touch_ = 0;                    // m, the sum of two radii where all are equal; else 0
  double largest_radius_ = 0;           // m
  double skin_ = -1;                    // m, of the long lists; negative: there are none
  double thin_skin_ = -1;               // m, of the short lists
  int list_threads_ = 0;                // for which it was made
  double moved_ = 0;                    // m: no ball has moved further since then
  double moved_before_ = 0;             // m, of that: before the lists were shortened
  double fastest_ = 0;                  // m/s
  double dt_ = 0;                       // s
  std::vector<double> speeds_;          // of each share's fastest ball, squared
  long long lists_built_ = 0;
};

}  // namespace bounce::many
